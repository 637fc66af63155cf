#include "render/export/decimal_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace pomona {

void append_number(std::string& text, double number, double step) {
  std::array<char, 40> digits{};
  // Adding zero makes -0 and 0 the same. Dividing by the whole inverse rounds right; multiplying by the step does not.
  const double rounded = std::round(number / step) / std::round(1 / step) + 0.0;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), rounded).ptr);
}

std::string exact(double number) {
  std::array<char, 40> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0).ptr};
}

std::string exact_words(const glm::dvec3& v) { return exact(v.x) + " " + exact(v.y) + " " + exact(v.z); }

}  // namespace pomona
