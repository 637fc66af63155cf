// The endings of files, which programs on Windows write in capitals.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

/// ".ply" of "SCAN.PLY" and "scan.ply".
inline std::string small_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

}  // namespace pomona
