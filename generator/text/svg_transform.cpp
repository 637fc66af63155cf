#include "generator/text/svg_transform.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr double largest_entry = 1e9;
constexpr std::size_t max_steps = 1000;

bool fits(const SvgTransform& t) {
  const double entries[] = {t.a, t.b, t.c, t.d, t.e, t.f};
  return std::all_of(std::begin(entries), std::end(entries), [](double v) { return std::fabs(v) <= largest_entry; });
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

void skip_separators(std::string_view& text) {
  while (!text.empty() && (is_space(text.front()) || text.front() == ',')) text.remove_prefix(1);
}

/// Takes the numbers up to the closing bracket, and the bracket. Nothing if there is anything else.
std::optional<std::vector<double>> take_numbers(std::string_view& text) {
  const std::size_t end = text.find(')');
  if (end == std::string_view::npos) return {};
  std::string_view inside = text.substr(0, end);
  text.remove_prefix(end + 1);
  std::vector<double> numbers;
  for (skip_separators(inside); !inside.empty(); skip_separators(inside)) {
    // A number ends at a separator, or at the sign of the next one.
    std::size_t length = 1;
    while (length < inside.size() && !is_space(inside[length]) && inside[length] != ',') {
      const bool is_sign = inside[length] == '-' || inside[length] == '+';
      if (is_sign && inside[length - 1] != 'e' && inside[length - 1] != 'E') break;
      ++length;
    }
    const std::optional<double> number = parse_number(inside.substr(0, length));
    if (!number || numbers.size() == 6) return {};
    numbers.push_back(*number);
    inside.remove_prefix(length);
  }
  return numbers;
}

SvgTransform rotation(double degrees) {
  const double c = reproducible::cos(radians(degrees)), s = reproducible::sin(radians(degrees));
  return {c, s, -s, c, 0, 0};
}

double tangent(double degrees) { return reproducible::sin(radians(degrees)) / reproducible::cos(radians(degrees)); }

std::optional<SvgTransform> step(std::string_view name, const std::vector<double>& n) {
  if (name == "matrix" && n.size() == 6) return SvgTransform{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && n.size() == 1) return translation({n[0], 0});
  if (name == "translate" && n.size() == 2) return translation({n[0], n[1]});
  if (name == "scale" && n.size() == 1) return SvgTransform{n[0], 0, 0, n[0], 0, 0};
  if (name == "scale" && n.size() == 2) return SvgTransform{n[0], 0, 0, n[1], 0, 0};
  if (name == "rotate" && n.size() == 1) return rotation(n[0]);
  if (name == "rotate" && n.size() == 3) {
    const glm::dvec2 center(n[1], n[2]);
    return translation(center) * rotation(n[0]) * translation(-center);
  }
  if (name == "skewX" && n.size() == 1) return SvgTransform{1, 0, tangent(n[0]), 1, 0, 0};
  if (name == "skewY" && n.size() == 1) return SvgTransform{1, tangent(n[0]), 0, 1, 0, 0};
  return {};
}

}  // namespace

SvgTransform operator*(const SvgTransform& outer, const SvgTransform& inner) {
  const glm::dvec2 moved = outer({inner.e, inner.f});
  return {outer.a * inner.a + outer.c * inner.b,
          outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,
          outer.b * inner.c + outer.d * inner.d,
          moved.x,
          moved.y};
}

SvgTransform translation(const glm::dvec2& by) { return {1, 0, 0, 1, by.x, by.y}; }

std::optional<SvgTransform> inverse(const SvgTransform& t) {
  const double det = t.a * t.d - t.b * t.c;
  if (!(std::fabs(det) > 1e-18)) return {};
  SvgTransform result{t.d / det, -t.b / det, -t.c / det, t.a / det, 0, 0};
  const glm::dvec2 moved = result({t.e, t.f});
  result.e = -moved.x;
  result.f = -moved.y;
  return result;
}

double largest_stretch(const SvgTransform& t) {
  // The larger singular value of the 2 x 2 matrix.
  const double sum = t.a * t.a + t.b * t.b + t.c * t.c + t.d * t.d;
  const double det = t.a * t.d - t.b * t.c;
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * det * det))));
}

std::optional<SvgTransform> parse_svg_transform(std::string_view text) {
  SvgTransform all;
  std::size_t steps = 0;
  for (skip_separators(text); !text.empty(); skip_separators(text)) {
    const std::size_t bracket = text.find('(');
    if (bracket == std::string_view::npos || ++steps > max_steps) return {};
    std::string_view name = text.substr(0, bracket);
    while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
    text.remove_prefix(bracket + 1);
    const std::optional<std::vector<double>> numbers = take_numbers(text);
    const std::optional<SvgTransform> next = numbers ? step(name, *numbers) : std::nullopt;
    if (!next) return {};
    all = all * *next;
    if (!fits(all)) return {};
  }
  return all;
}

}  // namespace pomona
