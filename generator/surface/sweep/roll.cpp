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

/// Where the vertices of all sheets of a roll are.
class Roll {
 public:
  Roll(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options)
      : fruit_(fruit), sketch_(sketch), steps_(turn_steps(sketch, options)) {
    const double columns = std::floor(sketch.turns * steps_);
    columns_ = std::max(3, static_cast<int>(columns) + 1);
    pitch_ = static_cast<double>(steps_) / (columns_ - 1) / sketch.count;
    const int along = refined(sketch.along, options.detail, 3);
    for (int j = 0; j < along; ++j) ways_.push_back(way_at(static_cast<double>(j) / (along - 1)));
    for (const Way& way : ways_) check(way);
    const RandomStream random(options.key, "sheet/" + sketch.name);
    for (int k = 0; k < 2; ++k) phase_[k] = 2 * pi * random.uniform(static_cast<std::uint64_t>(k));
    for (const Way& way : ways_) widest_ = std::max({widest_, way.from.x, way.to.x});
  }

  SweptGrid shell(int sheet) const {
    std::vector<glm::dvec3> faces[2];
    const int first = sheet * steps_ / sketch_.count;
    for (const Way& way : ways_) {
      for (int i = 0; i < columns_; ++i) {
        const double azimuth = 2 * pi * ((first + i) % steps_) / steps_;
        for (int side = 0; side < 2; ++side) faces[side].push_back(turned(face(way, i, side), azimuth));
      }
    }
    const double age = sketch_.count > 1 ? sheet / (sketch_.count - 1.0) : 0;
    return sheet_shell(faces[0], faces[1], columns_, static_cast<int>(ways_.size()), age);
  }

 private:
  /// Vertices of one turn: so many that every sheet begins at one, and those of the next turn lie over them.
  static int turn_steps(const SheetSketch& sketch, const SweepOptions& options) {
    const int wanted = refined(sketch.around, options.detail, 8);
    return (wanted + sketch.count - 1) / sketch.count * sketch.count;
  }

  Way way_at(double share) const {
    constexpr double step = 1e-3;
    const double below = std::max(0.0, share - step), above = std::min(1.0, share + step);
    Way way{point_at(sketch_.inner, share), point_at(sketch_.outer, share), share, sketch_.thickness(share)};
    const glm::dvec2 across = way.to - way.from;
    const auto slant = [&](const Curve& curve) {
      const glm::dvec2 upwards = point_at(curve, above) - point_at(curve, below);
      const double size = glm::length(across) * glm::length(upwards);
      return size > 0 ? cross(across, upwards) / size : 0;
    };
    way.slant[0] = slant(sketch_.inner);
    way.slant[1] = slant(sketch_.outer);
    return way;
  }

  [[noreturn]] void refuse_roll(const char* why, const char* hint) const {
    refuse_entry(fruit_, "sheets", sketch_.name, why, hint);
  }

  /// Turns keep apart where each is thinner than its share of the way.
  void check(const Way& way) const {
    constexpr double least_slant = 0.1;
    if (!(way.slant[0] * ways_.front().slant[0] > 0) || !(way.slant[1] * ways_.front().slant[0] > 0) ||
        std::min(std::fabs(way.slant[0]), std::fabs(way.slant[1])) < least_slant)
      refuse_roll("the two curves cross, or run apart too steeply",
                  "draw both the same way, with the outer one everywhere beside the inner one");
    for (int i = 0; i < columns_; ++i) {
      const double room = pitch_ * glm::distance(way.from, way.to) * slant_at(way, i);
      if (thickness(way, i) + sketch_.gap > room)
        refuse_roll("so many turns have no room", "make them fewer or thinner, or the outer curve wider");
      if (face(way, i, 0).x < 1e-5)
        refuse_roll("its innermost turn reaches the axis", "draw the inner curve further from the axis");
    }
  }

  double height(int column) const { return static_cast<double>(column) / (columns_ - 1); }
  double slant_at(const Way& way, int column) const {
    return std::fabs(way.slant[0] + height(column) * (way.slant[1] - way.slant[0]));
  }

  double thickness(const Way& way, int column) const { return way.thickness * sketch_.by_age(height(column)); }

  /// A face's place in the side view: the middle of the sheet, and half its thickness to either side.
  glm::dvec2 face(const Way& way, int column, int side) const {
    const double end = std::min(column, columns_ - 1 - column) / (0.04 * steps_);
    const double margin = std::clamp(std::min(end, std::min(way.share, 1 - way.share) / 0.04), 0.2, 1.0);
    const glm::dvec2 across = way.to - way.from;
    const double half = 0.5 * margin * thickness(way, column) / slant_at(way, column);
    return way.from + across * height(column) + glm::normalize(across) * (side == 0 ? -half : half);
  }

  /// All turns wave alike, so they keep their order.
  glm::dvec3 turned(const glm::dvec2& at, double azimuth) const {
    const double wave = 0.5 * (reproducible::cos(2 * azimuth + phase_[0]) + reproducible::cos(3 * azimuth + phase_[1]));
    const double sway = std::min(sketch_.sway, 0.4 * widest_);
    const double radius = at.x * (1 + sway * wave / widest_);
    return {radius * reproducible::cos(azimuth), at.y, -radius * reproducible::sin(azimuth)};
  }

  const Template& fruit_;
  const SheetSketch& sketch_;
  int steps_ = 0;     ///< vertices of a turn
  int columns_ = 0;   ///< vertices from the inner end to the outer one
  double pitch_ = 0;  ///< from one turn to the next, as a share of the way
  double widest_ = 0;
  double phase_[2] = {0, 0};
  std::vector<Way> ways_;
};

}  // namespace

std::vector<SweptGrid> roll_shells(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const Roll roll(fruit, sketch, options);
  std::vector<SweptGrid> shells;
  for (int k = 0; k < sketch.count; ++k) shells.push_back(roll.shell(k));
  return shells;
}

}  // namespace pomona
