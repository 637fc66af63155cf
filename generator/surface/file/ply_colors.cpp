#include "generator/surface/file/ply_colors.h"

#include <algorithm>
#include <string>

#include "generator/surface/file/channel_scale.h"

namespace pomona {

namespace {

constexpr std::array<VectorNames, 5> srgb_names{{{"red", "green", "blue"},
                                                 {"diffuse_red", "diffuse_green", "diffuse_blue"},
                                                 {"r", "g", "b"},
                                                 {"color_r", "color_g", "color_b"},
                                                 {"color_red", "color_green", "color_blue"}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_but_for_capitals(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<int> channel_of(const PlyProperty& property, const VectorNames& names) {
  const auto found = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
    return !property.count_type && same_but_for_capitals(property.name, name);
  });
  return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
}

/// The names of an element's colours; nothing without colours.
std::optional<VectorNames> srgb_of(const PlyElement& element) {
  for (const VectorNames& names : srgb_names) {
    int channels = 0;
    for (const PlyProperty& property : element.properties) channels += channel_of(property, names) ? 1 : 0;
    if (channels == 3) return names;
  }
  return {};
}

}  // namespace

bool is_float(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

std::optional<std::string_view> unread_color(const PlyElement& element) {
  if (srgb_of(element)) return {};
  constexpr std::array<std::string_view, 5> words{"_red", "rgb", "color", "colour", "f_dc"};
  constexpr std::array<std::string_view, 4> names{"red", "gray", "grey", "intensity"};
  for (const PlyProperty& property : element.properties) {
    std::string name(property.name);
    std::transform(name.begin(), name.end(), name.begin(), lower);
    const auto is_in = [&](std::string_view word) { return name.find(word) != std::string::npos; };
    const bool is_one = std::find(names.begin(), names.end(), name) != names.end();
    if (is_one || std::any_of(words.begin(), words.end(), is_in)) return property.name;
  }
  return {};
}

PlyColors::PlyColors(const PlyElement& element) : names_(srgb_of(element)) {
  for (const PlyProperty& property : element.properties) {
    const std::optional<int> k = channel(property);
    if (k) type_[static_cast<std::size_t>(*k)] = property.type;
  }
}

std::optional<int> PlyColors::channel(const PlyProperty& property) const {
  return names_ ? channel_of(property, *names_) : std::nullopt;
}

void PlyColors::add(const glm::dvec3& color) {
  color_.push_back(color);
  for (int k = 0; k < 3; ++k)
    if (is_float(type_[static_cast<std::size_t>(k)])) largest_float_ = std::max(largest_float_, color[k]);
}

Color PlyColors::linear(std::size_t i) const {
  Color color;
  for (int k = 0; k < 3; ++k)
    color[k] = static_cast<float>(linear_from_srgb(std::clamp(color_[i][k] / white(k), 0.0, 1.0)));
  return color;
}

double PlyColors::white(int k) const {
  const PlyType type = type_[static_cast<std::size_t>(k)];
  if (is_float(type)) return white_of_floats(largest_float_);
  return type == PlyType::int16 || type == PlyType::uint16 ? 65535 : 255;
}

}  // namespace pomona
