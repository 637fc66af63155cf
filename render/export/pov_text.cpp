#include "render/export/pov_text.h"

#include <array>
#include <charconv>

#include "generator/base/number_text.h"
#include "generator/base/utf8.h"

namespace pomona::pov {
namespace {

template <typename Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

}  // namespace

std::string vector_text(const glm::dvec3& v) {
  return "<" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + ">";
}

void append_integer(std::string& text, std::int64_t number) { append_number(text, number); }

void append_integers(std::string& text, std::int64_t x, std::int64_t y, std::int64_t z) {
  text += '<';
  append_number(text, x);
  text += ',';
  append_number(text, y);
  text += ',';
  append_number(text, z);
  text += '>';
}

double power_of_ten(int exponent) {
  const std::string text = "1e" + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

int exponent_for(double size, int digits) {
  int exponent = -60;
  while (exponent < 60 && size / power_of_ten(exponent) >= power_of_ten(digits + 1)) ++exponent;
  return exponent;
}

std::string commentable(std::string_view any_text) {
  std::string text = as_utf8(any_text);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace pomona::pov
