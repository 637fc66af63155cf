// The endings of files, which programs on Windows write in capitals.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

/// The text with the letters A to Z as a to z; all others stay.
inline std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// ".ply" of "SCAN.PLY" and "scan.ply".
inline std::string small_ending(const std::filesystem::path& file) {
  return in_small_letters(file.extension().string());
}

}  // namespace pomona
