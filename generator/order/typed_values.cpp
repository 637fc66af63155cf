#include "generator/order/typed_values.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr std::size_t max_seeds = 64;
constexpr std::size_t max_ripeness_variants = 16;

struct NamedView {
  std::string_view name;
  glm::dvec3 direction;
};
constexpr NamedView named_views[] = {
    {"front", {0, 0, 1}},
    {"back", {0, 0, -1}},
    {"left", {-1, 0, 0}},
    {"right", {1, 0, 0}},
    {"top", {0, 1, 0}},
    {"bottom", {0, -1, 0}},
    {"three-quarter", {0.5, 0.55, 1}},
};

[[noreturn]] void refuse_seeds(const std::string& text) {
  throw Error(ExitStatus::usage, "--seeds " + text + " is no list of seeds",
              "write --seeds 1-5, or --seeds 0,2,7: up to 64 seeds, rising");
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Inches per unit of paper; 0 for pixels, nothing for other texts.
std::optional<double> inches_of(const std::string& unit) {
  if (unit.empty()) return 0.0;
  if (unit == "in") return 1.0;
  if (unit == "mm") return 1 / 25.4;
  if (unit == "cm") return 1 / 2.54;
  return std::nullopt;
}

[[noreturn]] void refuse_extent(const std::string& text) {
  throw Error(ExitStatus::usage, "--size " + text + " is not a picture size",
              "write 800x600, or 120x90mm with --dpi 300; 16 to 16384 pixels a side");
}

/// A side; its unit may stand at the other side.
double side_of(std::string side, const std::string& unit, const std::string& text) {
  if (side.ends_with(unit)) side.resize(side.size() - unit.size());
  const std::optional<double> number = parse_number(side);
  if (!number) refuse_extent(text);
  return *number;
}

}  // namespace

void read_seeds(Order& order, const std::string& text) {
  std::vector<std::uint64_t>& seeds = order.fruit.seeds;
  seeds.clear();
  const std::size_t dash = text.find('-');
  if (dash != std::string::npos) {
    const auto first = whole_number(text.substr(0, dash)), last = whole_number(text.substr(dash + 1));
    if (!first || !last || *last < *first || *last - *first >= max_seeds) refuse_seeds(text);
    for (std::uint64_t seed = *first; seeds.size() <= *last - *first; ++seed) seeds.push_back(seed);
    return;
  }
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const auto seed = whole_number(text.substr(from, comma - from));
    if (!seed || seeds.size() == max_seeds) refuse_seeds(text);
    seeds.push_back(*seed);
    from = comma + 1;
  }
}

std::string seeds_text(const Order& order) {
  const std::vector<std::uint64_t>& seeds = order.fruit.seeds;
  const bool is_range = seeds.size() > 1 && std::adjacent_find(seeds.begin(), seeds.end(), [](auto a, auto b) {
                                              return b != a + 1;
                                            }) == seeds.end();
  if (is_range) return std::to_string(seeds.front()) + "-" + std::to_string(seeds.back());
  std::string text;
  for (const std::uint64_t seed : seeds) text += (text.empty() ? "" : ",") + std::to_string(seed);
  return text;
}

void read_texel(Order& order, const std::string& text) {
  const std::optional<double> size = parse_length(text);
  const std::optional<double> bare = parse_number(text);
  if (bare && *bare > 0) throw Error(ExitStatus::usage, "--texel " + text + " has no unit", "write " + text + "mm");
  if (!size || !(*size > 0))
    throw Error(ExitStatus::usage, "--texel " + text + " is not the size of a texel", "write a length above 0: 0.2mm");
  order.mesh.texel = {text, *size};
}

void read_ripeness_variants(Order& order, const std::string& text) {
  std::vector<double>& wanted = order.mesh.ripeness_variants;
  wanted.clear();
  std::istringstream words(text + ",");
  for (std::string word; std::getline(words, word, ',');) {
    const std::optional<double> ripeness = parse_number(word);
    const bool is_new = ripeness && std::find(wanted.begin(), wanted.end(), *ripeness) == wanted.end();
    if (!is_new || !(*ripeness >= 0 && *ripeness <= 2) || wanted.size() == max_ripeness_variants)
      throw Error(ExitStatus::usage, "--ripeness-variants " + text + ": \"" + word + "\" is no further ripeness",
                  "write up to 16 numbers from 0 to 2, as in 0.3,1,1.7");
    wanted.push_back(*ripeness);
  }
}

std::string ripeness_variants_text(const Order& order) {
  std::ostringstream text;
  for (const double ripeness : order.mesh.ripeness_variants) text << (text.tellp() > 0 ? "," : "") << ripeness;
  return text.str();
}

void read_picture_extent(Order& order, const std::string& text) {
  // The height's unit is that of both.
  const std::size_t x = text.find('x');
  const std::string height = x == std::string::npos ? std::string() : text.substr(x + 1);
  const std::size_t digits = height.find_last_of("0123456789.");
  if (digits == std::string::npos) refuse_extent(text);
  const std::string unit = height.substr(digits + 1);
  const std::optional<double> inches = inches_of(unit);
  if (!inches) refuse_extent(text);
  order.picture.size =
      PictureExtent{text, side_of(text.substr(0, x), unit, text), side_of(height, unit, text), *inches};
}

void read_viewpoint(Order& order, const std::string& text) {
  for (const NamedView& view : named_views) {
    if (text == view.name) return void(order.picture.view = Viewpoint{text, view.direction});
  }
  const std::size_t comma = text.find(',');
  const auto azimuth = parse_number(text.substr(0, comma));
  const auto elevation = comma == std::string::npos ? std::nullopt : parse_number(text.substr(comma + 1));
  if (!azimuth || !elevation || *elevation < -90 || *elevation > 90)
    throw Error(
        ExitStatus::usage, "--view " + text + " is not a view",
        "front, back, left, right, top, bottom, three-quarter, or AZIMUTH,ELEVATION as in 30,20; elevations are "
        "-90 to 90");
  const double a = radians(*azimuth), e = radians(*elevation);
  order.picture.view = Viewpoint{text, glm::dvec3(reproducible::cos(e) * reproducible::sin(a), reproducible::sin(e),
                                                  reproducible::cos(e) * reproducible::cos(a))};
}

std::string view_type() {
  std::string names;
  for (const NamedView& view : named_views) names.append(names.empty() ? "" : ",").append(view.name);
  return "VIEW:{" + names + "}";
}

}  // namespace pomona
