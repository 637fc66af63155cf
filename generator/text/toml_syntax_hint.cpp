#include "generator/text/toml_syntax_hint.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pomona {

namespace {

constexpr std::string_view ten_digits = "0123456789";
constexpr std::string_view latin_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

bool is_one_of(std::string_view characters, char c) { return characters.find(c) != std::string_view::npos; }

/// The line of this number, from 1, without its end.
std::string_view line_of(std::string_view text, int number) {
  for (int i = 1; i < number; ++i) {
    const std::size_t end = text.find('\n');
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return text.substr(0, text.find_first_of("\r\n"));
}

/// The byte at which the character of this number, from 1, begins.
std::size_t byte_of(std::string_view line, int column) {
  int characters = 0;
  for (std::size_t byte = 0; byte < line.size(); ++byte) {
    const bool begins_one = (static_cast<unsigned char>(line[byte]) & 0xc0) != 0x80;
    if (begins_one && ++characters == column) return byte;
  }
  return line.size();
}

/// What is behind the first "=".
std::string_view value_in(std::string_view line) {
  const std::size_t equals = line.find('=');
  const std::size_t begin = line.find_first_not_of(" \t", equals == std::string_view::npos ? 0 : equals + 1);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
}

/// The value that the byte is in.
std::string_view word_at(std::string_view line, std::size_t byte) {
  const std::size_t before = line.substr(0, byte).find_last_of(" \t=,[{");
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return line.substr(begin, line.find_first_of(" \t,]}", byte) - begin);
}

/// What a value lacks that is no value.
std::string hint_for_word(std::string_view word) {
  constexpr std::size_t longest = 40;
  const std::string shown(word.substr(0, longest));
  if (word == "True" || word == "False") return "write it in small letters: true, false";
  if (word.starts_with("\xe2\x80")) return "quotes are straight: \"";  // typographic ones begin so in UTF-8
  if (word.size() > 1 && word[0] == '.' && is_one_of(ten_digits, word[1])) return "write 0" + shown;
  const bool is_color = word.starts_with("#"), is_text = word.find_first_of(latin_letters) != std::string_view::npos;
  const bool is_open = word.find_first_of("\"'#[]{}", is_color ? 1 : 0) != std::string_view::npos;
  if (is_open || word.size() > longest || !(is_color || is_text)) return {};
  return std::string(is_color ? "colours" : "texts and lengths") + " stand in quotes: \"" + shown + "\"";
}

bool is_decimal_comma(std::string_view line, std::size_t byte) {
  return byte > 0 && byte + 1 < line.size() && line[byte] == ',' && is_one_of(ten_digits, line[byte - 1]) &&
         is_one_of(ten_digits, line[byte + 1]);
}

}  // namespace

std::string toml_syntax_hint(std::string_view text, TomlPlace place, std::string_view fault) {
  constexpr std::array by_fault = {
      std::pair("as array-of-tables", "an earlier heading of it lacks its second brackets, or is mistyped"),
      std::pair("inline table: expected key or closing '}', saw '\\n'", "what is in { } stands on one line"),
      std::pair("string: unescaped control characters", "the text lacks the quotes at its end"),
      std::pair("expected '=', saw ':'", "write a key and its value so: name = \"plum\"")};
  const auto says = [&](std::string_view part) { return fault.find(part) != std::string_view::npos; };
  for (const auto& [part, hint] : by_fault)
    if (says(part)) return hint;
  const std::string_view line = line_of(text, place.line);
  const std::size_t byte = byte_of(line, place.column);
  if (says("header") || says("redefine") || byte >= line.size()) return {};
  if (is_decimal_comma(line, byte)) return "decimals have a point: 0.5";
  return hint_for_word(says("expected a comment") ? value_in(line) : word_at(line, byte));
}

}  // namespace pomona
