// Colours that PLY files have for viewers: red, green and blue by several names, of bytes, words or floats.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/surface/file/ply_header.h"

namespace pomona {

/// The names of three properties that form a vector.
using VectorNames = std::array<std::string_view, 3>;

bool is_float(PlyType type);

/// The name of a property that seems to be a colour, if an element has its colours by names that are not read.
std::optional<std::string_view> unread_color(const PlyElement& element);

/// The colours of an element's items as in the file, sRGB. A full channel is 255 for bytes; for floats it depends on
/// the largest.
class PlyColors {
 public:
  explicit PlyColors(const PlyElement& element);

  bool is_there() const { return names_.has_value(); }
  /// Which channel the property is, if any.
  std::optional<int> channel(const PlyProperty& property) const;
  void add(const glm::dvec3& color);
  const glm::dvec3& operator[](std::size_t i) const { return color_[i]; }
  Color linear(std::size_t i) const;

 private:
  double white(int k) const;

  std::optional<VectorNames> names_;
  std::array<PlyType, 3> type_{};
  std::vector<glm::dvec3> color_;
  double largest_float_ = 0;
};

}  // namespace pomona
