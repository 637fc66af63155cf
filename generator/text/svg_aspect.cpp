#include "generator/text/svg_aspect.h"

#include <algorithm>
#include <optional>

namespace pomona {

namespace {

std::optional<double> share_of(std::string_view word) {
  if (word == "Min") return 0;
  if (word == "Mid") return 0.5;
  return word == "Max" ? std::optional<double>(1) : std::nullopt;
}

std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

SvgAspect parse_svg_aspect(std::string_view text) {
  std::string_view align = next_word(text);
  if (align == "defer") align = next_word(text);
  if (align == "none") return {.stretches = true, .slices = false, .align = glm::dvec2(0.5)};
  const bool has_form = align.size() == 8 && align[0] == 'x' && align[4] == 'Y';
  const auto x = has_form ? share_of(align.substr(1, 3)) : std::nullopt;
  const auto y = has_form ? share_of(align.substr(5, 3)) : std::nullopt;
  if (!x || !y) return {};
  return {.stretches = false, .slices = next_word(text) == "slice", .align = {*x, *y}};
}

}  // namespace pomona
