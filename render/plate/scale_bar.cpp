#include "render/plate/scale_bar.h"

#include <utility>

namespace pomona {

namespace {

std::string length_text(double metres) {
  const auto [unit, name] = metres < 0.00995 ? std::pair(0.001, "mm")
                            : metres < 0.995 ? std::pair(0.01, "cm")
                                             : std::pair(1.0, "m");
  const double number = metres / unit;
  if (number >= 0.995) return std::to_string(static_cast<long>(number + 0.5)) + " " + name;
  std::string text = std::to_string(number);  // for a tenth of a millimetre and less
  text.erase(text.find_last_not_of('0') + 1);
  return text + " " + name;
}

}  // namespace

ScaleLength scale_length(double max, double pixels_per_metre) {
  if (!(pixels_per_metre > 0)) return {};
  const double longest = max / pixels_per_metre;
  double power = 1e-7;
  while (power * 10 <= longest) power *= 10;
  const double metres = longest >= 5 * power ? 5 * power : longest >= 2 * power ? 2 * power : power;
  return {metres, length_text(metres), metres * pixels_per_metre};
}

}  // namespace pomona
