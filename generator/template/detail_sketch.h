// Texture detail that follows a fruit's surfaces: fibres, cells, speckles, streaks, nets, or by example (paper, section
// 6).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/template/example_tile.h"
#include "generator/template/ramp.h"

namespace pomona {

/// The appearance of a detail (docs/reference/style.md has pictures and formulas).
enum class DetailKind {
  fibres,    ///< thin lines
  cells,     ///< packed bodies, each a little different, with a line where two meet
  speckles,  ///< dots
  streaks,   ///< long, uneven brush marks
  net,       ///< lines that stand out where cells meet
  example,   ///< what a picture of some flesh shows
};

/// The direction of the fruit along which a detail is stretched.
enum class DetailRun {
  none,     ///< the same in all directions
  to_skin,  ///< straight out from the core, across the layers
  along,    ///< from pole to pole within a layer
  around,   ///< around the axis within a layer
};

/// Cut faces, or skin.
enum class DetailFace { cut, skin };

struct DetailSketch {
  DetailKind kind = DetailKind::fibres;
  DetailFace face = DetailFace::cut;
  DetailRun run = DetailRun::none;
  std::vector<int> parts;  ///< indices into Template::parts

  double size = 1e-3;      ///< distance of lines or cells, width of the largest dot, or of the example's tile, metres
  double smallest = 1e-3;  ///< width of the smallest dot, metres
  double length = 1e-3;    ///< length along the run, metres; equal to `size` without a run
  double width = 0.3;      ///< width of lines, as a share of `size`
  double density = 0.5;    ///< dots: share of the lattice points with a dot; lines and streaks: share of the area
  double softness = 0.5;   ///< 0 = hard rims, 1 = soft everywhere
  double wander = 0;       ///< deviation of lines from straight ones, as a share of `size`
  double variety = 0.5;    ///< difference between cells, as a share of `amount`

  double amount = 0;           ///< change of colours: with `color`, a share of the way to it; of examples, a share of
                               ///< their contrast; else in OKLab units
  std::optional<Color> color;  ///< colours change towards this one; nothing = along `axis`
  glm::vec3 axis{1, 0, 0};     ///< direction of the change in OKLab, without `color`
  std::optional<Color> near;   ///< the detail only affects colours near this unmodulated one; nothing = all
  double near_within = 0.12;   ///< OKLab distance over which the effect fades
  Ramp<double> depth = Ramp<double>::constant(1);  ///< share of the amount by the depth below the skin, metres
  std::shared_ptr<const ExampleTile> tile;         ///< of an example; else null
  double relief = 0;  ///< height of the marks, metres, negative = below the surface; only for shading

  double reach = 0.03;   ///< metres: the fruit's largest drawn radius
  double middle = 0.03;  ///< metres: half its drawn height

  std::uint32_t pattern = 0;  ///< as of NoiseStyle
};

/// Largest number of details of one kind of face.
constexpr int max_details_of_a_face = 4;

}  // namespace pomona
