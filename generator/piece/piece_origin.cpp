#include "generator/piece/piece_origin.h"

#include <filesystem>

namespace pomona {

std::string source_word(const std::string& name_or_path) {
  const std::filesystem::path path = name_or_path;
  const std::string word = path.is_absolute() ? path.filename().string() : name_or_path;
  return word.starts_with('-') ? "./" + word : word;
}

std::string knives_text(const PieceOrigin& origin) {
  std::string text;
  for (const std::string& knife : origin.knives) text += (text.empty() ? "" : " ") + knife;
  return text;
}

}  // namespace pomona
