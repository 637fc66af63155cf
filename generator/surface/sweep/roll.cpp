// Rolls: sheets wound around the axis, every turn a little further out than the one before.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/sheet_shells.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

/// The straight way from the innermost turn to the outermost, at one share of both curves.
struct Way {
  glm::dvec2 from{0}, to{0};
  double share = 0;      ///< of the curves, from their base
  double thickness = 0;  ///< of a sheet there, before its age counts, metres
  /// What a metre across the turns takes on this way, or 0 where it runs along them: at the innermost and outermost.
  double slant[2] = {1, 1};
};

Way way_at(const SheetSketch& sketch, double share) {
  constexpr double step = 1e-3;
  const double below = std::max(0.0, share - step), above = std::min(1.0, share + step);
  Way way{point_at(sketch.inner, share), point_at(sketch.outer, share), share, sketch.thickness(share)};
  const glm::dvec2 across = way.to - way.from;
  const auto slant = [&](const Curve& curve) {
    const glm::dvec2 rise = point_at(curve, above) - point_at(curve, below);
    const double size = glm::length(across) * glm::length(rise);
    return size > 0 ? cross(across, rise) / size : 0;
  };
  way.slant[0] = slant(sketch.inner);
  way.slant[1] = slant(sketch.outer);
  return way;
}

/// What all sheets of a roll share.
struct Roll {
  int steps = 0;      ///< vertices of a turn
  int columns = 0;    ///< vertices from the inner end to the outer one
  double pitch = 0;   ///< from one turn to the next, as a share of the way
  double widest = 0;  ///< distance of its farthest end of a way from the axis, metres
  double phase[2] = {0, 0};
  std::vector<Way> ways = {};
};

/// Vertices of one turn: so many that every sheet begins at one, and those of the next turn lie over them.
int steps_of_turn(const SheetSketch& sketch, const SweepOptions& options) {
  const int wanted = refined(sketch.around, options.detail, 8);
  return (wanted + sketch.count - 1) / sketch.count * sketch.count;
}

Roll roll_of(const SheetSketch& sketch, const SweepOptions& options) {
  Roll roll;
  roll.steps = steps_of_turn(sketch, options);
  roll.columns = std::max(3, static_cast<int>(std::floor(sketch.turns * roll.steps)) + 1);
  roll.pitch = static_cast<double>(roll.steps) / (roll.columns - 1) / sketch.count;
  const int along = refined(sketch.along, options.detail, 3);
  for (int j = 0; j < along; ++j) roll.ways.push_back(way_at(sketch, static_cast<double>(j) / (along - 1)));
  for (const Way& way : roll.ways) roll.widest = std::max({roll.widest, way.from.x, way.to.x});
  const RandomStream random(options.key, "sheet/" + sketch.name);
  for (int k = 0; k < 2; ++k) roll.phase[k] = 2 * pi * random.uniform(static_cast<std::uint64_t>(k));
  return roll;
}

/// How far a column lies from the innermost turn, as a share of the way.
double height_of(const Roll& roll, int column) { return static_cast<double>(column) / (roll.columns - 1); }

double slant_at(const Roll& roll, const Way& way, int column) {
  return std::fabs(way.slant[0] + height_of(roll, column) * (way.slant[1] - way.slant[0]));
}

double thickness_at(const Roll& roll, const SheetSketch& sketch, const Way& way, int column) {
  return way.thickness * sketch.by_age(height_of(roll, column));
}

/// A face's place in the side view: the middle of the sheet, and half its thickness to either side.
glm::dvec2 face_at(const Roll& roll, const SheetSketch& sketch, const Way& way, int column, int side) {
  const double end = std::min(column, roll.columns - 1 - column) / (0.04 * roll.steps);
  const double margin = std::clamp(std::min(end, std::min(way.share, 1 - way.share) / 0.04), 0.2, 1.0);
  const glm::dvec2 across = way.to - way.from;
  const double half = 0.5 * margin * thickness_at(roll, sketch, way, column) / slant_at(roll, way, column);
  return way.from + across * height_of(roll, column) + glm::normalize(across) * (side == 0 ? -half : half);
}

/// All turns wave alike, so they keep their order.
glm::dvec3 turned(const Roll& roll, const SheetSketch& sketch, const glm::dvec2& at, double azimuth) {
  const double wave =
      0.5 * (reproducible::cos(2 * azimuth + roll.phase[0]) + reproducible::cos(3 * azimuth + roll.phase[1]));
  const double sway = std::min(sketch.sway, 0.4 * roll.widest);
  const double radius = at.x * (1 + sway * wave / roll.widest);
  return {radius * reproducible::cos(azimuth), at.y, -radius * reproducible::sin(azimuth)};
}

/// Turns keep apart where each is thinner than its share of the way.
void check_way(const Template& fruit, const SheetSketch& sketch, const Roll& roll, const Way& way) {
  constexpr double least_slant = 0.1;
  const double first = roll.ways.front().slant[0];
  if (!(way.slant[0] * first > 0) || !(way.slant[1] * first > 0) ||
      std::min(std::fabs(way.slant[0]), std::fabs(way.slant[1])) < least_slant)
    refuse_entry(fruit, "sheets", sketch.name, "the two curves cross, or run apart too steeply",
                 "draw both the same way, with the outer one everywhere beside the inner one");
  for (int i = 0; i < roll.columns; ++i) {
    const double room = roll.pitch * glm::distance(way.from, way.to) * slant_at(roll, way, i);
    if (thickness_at(roll, sketch, way, i) + sketch.gap > room)
      refuse_entry(fruit, "sheets", sketch.name, "so many turns have no room",
                   "make them fewer or thinner, or the outer curve wider");
    if (face_at(roll, sketch, way, i, 0).x < 1e-5)
      refuse_entry(fruit, "sheets", sketch.name, "its innermost turn reaches the axis",
                   "draw the inner curve further from the axis");
  }
}

SweptGrid rolled_sheet(const Roll& roll, const SheetSketch& sketch, int sheet) {
  std::vector<glm::dvec3> faces[2];
  const int first = sheet * roll.steps / sketch.count;
  for (const Way& way : roll.ways) {
    for (int i = 0; i < roll.columns; ++i) {
      const double azimuth = 2 * pi * ((first + i) % roll.steps) / roll.steps;
      for (int side = 0; side < 2; ++side)
        faces[side].push_back(turned(roll, sketch, face_at(roll, sketch, way, i, side), azimuth));
    }
  }
  return sheet_shell(faces[0], faces[1], roll.columns, static_cast<int>(roll.ways.size()), age_of(sketch, sheet));
}

}  // namespace

SheetShell roll_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const Roll roll = roll_of(sketch, options);
  for (const Way& way : roll.ways) check_way(fruit, sketch, roll, way);
  return [roll, &sketch](int sheet) { return rolled_sheet(roll, sketch, sheet); };
}

}  // namespace pomona
