// SVG path data as polylines in metres.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/curve.h"
#include "generator/text/svg_transform.h"

namespace pomona {

struct SvgPathOptions {
  double unit = 1e-3;              ///< metres per SVG unit
  double tolerance = 1e-5;         ///< largest distance of a chord from its curve, metres: a tenth of a fine line
  std::size_t max_points = 65536;  ///< limit of points of all subpaths together
  SvgTransform transform = {};     ///< applied to the path's coordinates first
};

/// An error in path data, and a hint. The caller adds the place.
struct BadPath : std::runtime_error {
  BadPath(const std::string& message, std::string remedy) : std::runtime_error(message), hint(std::move(remedy)) {}
  std::string hint;
};

/// One curve for each subpath: scaled, y turned upwards, curves and arcs flattened, points on a grid of 2^-30 m,
/// no two in a row equal. Closed where the path says Z or ends where it began.
/// \throws BadPath for data that is not a path, numbers that are not finite or too large, or too many points.
std::vector<Curve> parse_svg_path(std::string_view data, const SvgPathOptions& options = {});

}  // namespace pomona
