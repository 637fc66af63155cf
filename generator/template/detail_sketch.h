// Texture detail that follows a fruit's surfaces: fibres, cells, speckles, streaks, nets (paper, section 6).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

/// What a detail looks like (docs/reference/style.md has pictures and formulas).
enum class DetailKind {
  fibres,    ///< thin lines
  cells,     ///< packed bodies, each a little different, with a line where two meet
  speckles,  ///< dots
  streaks,   ///< long, uneven brush marks
  net,       ///< lines that stand out where cells meet
};

/// Along which direction of the fruit a detail is drawn out.
enum class DetailRun {
  none,     ///< the same in all directions
  to_skin,  ///< straight out from the core, across the layers
  along,    ///< from pole to pole within a layer
  around,   ///< around the axis within a layer
};

/// Cut faces, or what faces air.
enum class DetailFace { cut, skin };

struct DetailSketch {
  DetailKind kind = DetailKind::fibres;
  DetailFace face = DetailFace::cut;
  DetailRun run = DetailRun::none;
  std::vector<int> parts;  ///< indices into Template::parts

  double size = 1e-3;      ///< metres: from line to line, from cell to cell, width of the largest dot
  double smallest = 1e-3;  ///< metres: width of the smallest dot
  double length = 1e-3;    ///< metres along the run; as `size` where there is none
  double width = 0.3;      ///< of lines, share of `size`
  double density = 0.5;    ///< of dots: share of the places that have one; of lines and streaks: of the area
  double softness = 0.5;   ///< 0 = hard rims, 1 = soft all through
  double wander = 0;       ///< by how much lines leave their straight way, share of `size`
  double variety = 0.5;    ///< of cells: how much they differ from each other, share of `amount`

  double amount = 0;           ///< how far colours go: a share of the way to `color`, else OKLab units
  std::optional<Color> color;  ///< towards this colour
  glm::vec3 axis{1, 0, 0};     ///< or in this OKLab direction
  std::optional<Color> near;   ///< only near this unmodulated colour
  double near_within = 0.12;   ///< OKLab distance over which that fades
  Ramp<double> depth = Ramp<double>::constant(1);  ///< share of the amount by the depth below the skin, metres
  double relief = 0;  ///< metres that the marks stand out, or are sunk where negative; the look alone, no vertex moves

  double reach = 0.03;   ///< metres: the fruit's largest drawn radius
  double middle = 0.03;  ///< metres: half its drawn height

  std::uint32_t pattern = 0;  ///< as of NoiseStyle
};

/// So many details of one kind of face count.
constexpr int most_details_of_a_face = 4;

}  // namespace pomona
