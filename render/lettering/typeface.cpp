#include "render/lettering/typeface.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/utf8.h"
#include "render/lettering/letter_files.h"

namespace pomona {

namespace {

constexpr int pieces_of_a_curve = 8;

/// The words of one line, as their own files have them.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  std::string_view word() {
    skip();
    const std::size_t end = std::min(text_.find(' '), text_.size());
    const std::string_view result = text_.substr(0, end);
    text_.remove_prefix(end);
    return result;
  }

  template <typename Number>
  Number number(int base) {
    skip();
    Number value{};
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value, base);
    if (error != std::errc{}) throw Error(ExitStatus::bug, "a file of letters is damaged");
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

  /// The next character that is no blank; 0 at the end.
  char sign() {
    skip();
    if (text_.empty()) return 0;
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }

 private:
  void skip() { text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size())); }
  std::string_view text_;
};

/// Path data of M, L, C and Z, y up, to closed lines of ems, y down.
Outline read_outline(Words& words, double units) {
  // Font units, y up, become ems, y down.
  const auto point = [&] {
    const int x = words.number<int>(10);
    const int y = words.number<int>(10);
    return glm::dvec2(x / units, -y / units);
  };

  // Every M begins a line; curves become straight pieces, and all lines close by themselves.
  Outline outline;
  for (char sign = words.sign(); sign != 0; sign = words.sign()) {
    if (sign == 'M') outline.emplace_back().push_back(point());
    if (sign == 'L') outline.back().push_back(point());
    if (sign != 'C') continue;
    const glm::dvec2 a = outline.back().back();
    const glm::dvec2 b = point();
    const glm::dvec2 c = point();
    const glm::dvec2 d = point();
    for (int i = 1; i <= pieces_of_a_curve; ++i) {
      const double t = static_cast<double>(i) / pieces_of_a_curve, s = 1 - t;
      outline.back().push_back(a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t));
    }
  }
  return outline;
}

/// The characters of UTF-8; what is none becomes U+FFFD.
std::vector<std::uint32_t> characters_of(std::string_view text) {
  std::vector<std::uint32_t> characters;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    characters.push_back(length == 0 ? 0xfffd : utf8_code(text.substr(0, length)));
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return characters;
}

}  // namespace

Typeface::Typeface(std::string_view name) {
  for (const EmbeddedFile& file : letter_files()) {
    if (file.stem() != name) continue;
    std::string_view rest = file.text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return;
  }
  throw Error(ExitStatus::bug, "there is no face \"" + std::string(name) + "\"");
}

void Typeface::read_line(std::string_view line) {
  Words words(line);
  const std::string_view what = words.word();
  if (what == "units") units_ = words.number<int>(10);
  if (what == "letter") {
    const auto character = words.number<std::uint32_t>(16);
    Letter& letter = letters_[character];
    letter.advance = words.number<int>(10) / units_;
    letter.outline = read_outline(words, units_);
  }
  if (what == "kern") {
    const auto left = words.number<std::uint32_t>(16);
    const auto right = words.number<std::uint32_t>(16);
    kern_[{left, right}] = words.number<int>(10) / units_;
  }
}

Typeface::SetLine Typeface::set(std::string_view text, double spacing) const {
  std::vector<Place> places;
  double at = 0;
  std::uint32_t before = 0;
  for (const std::uint32_t character : characters_of(text)) {
    const auto letter = letters_.find(character);
    const auto kern = kern_.find({before, character});
    if (kern != kern_.end()) at += kern->second;
    if (before != 0) at += spacing;
    if (letter != letters_.end()) places.push_back({&letter->second, at});
    at += letter != letters_.end() ? letter->second.advance : 0.5;
    before = character;
  }
  return {std::move(places), at};
}

double Typeface::width(std::string_view text, double spacing) const { return set(text, spacing).width; }

Outline Typeface::outline(std::string_view text, const glm::dvec2& start, double em, double spacing) const {
  Outline outline;
  for (const Place& place : set(text, spacing).places) {
    for (const auto& line : place.letter->outline) {
      std::vector<glm::dvec2>& moved = outline.emplace_back();
      for (const glm::dvec2& p : line) moved.push_back(start + (p + glm::dvec2(place.at, 0)) * em);
    }
  }
  return outline;
}

}  // namespace pomona
