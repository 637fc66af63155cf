#include "generator/knife/knife_planes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/millimetres.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/knife/stroke.h"

namespace pomona {

namespace {

constexpr double thinnest_slice = 1e-4;  // share of the fruit's diagonal
constexpr int max_facets = 8192;

/// Cosine and sine with the zeros and ones of quarter turns exact, so that such planes lie on the axes.
glm::dvec2 direction(double angle) {
  glm::dvec2 d(reproducible::cos(angle), reproducible::sin(angle));
  for (int i = 0; i < 2; ++i) {
    if (std::fabs(d[i]) < 1e-15) d[i] = 0;
    if (std::fabs(std::fabs(d[i]) - 1) < 1e-15) d[i] = d[i] < 0 ? -1 : 1;
  }
  return d;
}

/// Makes planes one by one, by std::visit over the kinds of knives.
class PlaneLayer {
 public:
  PlaneLayer(const Knife& knife, const Box<double>& bounds) : bounds_(bounds) { laid_.text = knife.text; }

  void operator()(const PlaneKnife& knife) { laid_.planes.push_back(knife.plane); }
  void operator()(const HalfKnife&) { laid_.planes.push_back({{0, 0, 1}, 0}); }
  void operator()(const AcrossKnife&) { laid_.planes.push_back({{0, 1, 0}, bounds_.center().y}); }
  void operator()(const SliceKnife& knife) { add_slices(knife.size, knife.axis); }
  void operator()(const DiceKnife& knife) {
    for (int axis = 0; axis < 3; ++axis) add_slices(knife.size, axis);
  }
  void operator()(const StickKnife& knife) {
    add_slices(knife.size, 0);
    add_slices(knife.size, 2);
  }

  /// Half-planes at 2 pi k / N from the start as whole planes in the order of their angle. Where N is odd, every other
  /// plane serves the half-plane behind the axis and is turned so that its normal still points to growing angles there.
  void operator()(const WedgeKnife& knife) {
    const int lines = knife.count % 2 == 0 ? knife.count / 2 : knife.count;
    laid_.wedges = knife.count;
    for (int i = 0; i < lines; ++i) {
      const glm::dvec2 d = direction(knife.start + pi * i / lines);
      const bool reversed = knife.count % 2 == 1 && i % 2 == 1;
      const glm::dvec3 normal(-d.y, 0, -d.x);
      laid_.planes.push_back({reversed ? -normal : normal, 0});
      laid_.reversed.push_back(reversed ? 1 : 0);
    }
  }

  void operator()(const StrokeKnife& knife) {
    if (crosses_itself(knife.points, glm::dvec2(bounds_.center()), glm::length(bounds_.size()))) {
      refuse_knife(laid_.text, "crosses itself where its ends go on straight", "draw its ends on beyond the fruit");
    }
    add_strokes({knife.points});
  }

  /// A wave is as long as a slice is thick, and an eighth of that above and below the level plane.
  void operator()(const CrinkleKnife& knife) {
    constexpr int steps = 8;  // number of steps of a wave

    // Finds how many waves reach across the fruit, and refuses more facets than can be cut in reasonable time.
    const std::vector<double> heights = slices_of(SliceThickness{knife.thickness}, 1);
    const double wave = knife.thickness, height = wave / 8;
    const double waves = std::ceil(0.5 * bounds_.size().x / wave) + 1;
    if (2 * waves * steps * static_cast<double>(heights.size()) > max_facets) {
      refuse_knife(laid_.text, "makes more than " + std::to_string(max_facets) + " facets", "take thicker slices");
    }

    // Draws a wave at each height. Where it turns from left to right its edges are in line, and cleaned() joins them.
    std::vector<std::vector<glm::dvec2>> strokes;
    for (const double y : heights) {
      std::vector<glm::dvec2> points;
      for (double i = waves * steps; i >= -waves * steps; --i) {
        const double x = bounds_.center().x + i / steps * wave;
        points.emplace_back(x, y + height * reproducible::sin(2 * pi * i / steps));
      }
      strokes.push_back(cleaned(points));
    }
    add_strokes(std::move(strokes));
  }

  KnifePlanes finish() {
    laid_.reversed.resize(laid_.planes.size(), 0);
    laid_.direction.resize(laid_.planes.size(), 0);
    if (laid_.strokes.empty()) {
      for (const std::uint8_t d : laid_.direction) ++laid_.across[d];
    }
    return std::move(laid_);
  }

 private:
  /// The number of whole slices along the fruit, and their thickness, metres.
  struct Slicing {
    double whole = 0, thickness = 0;
  };

  /// Slices by count are equal; of slices by thickness as many whole ones as fit.
  Slicing slicing(const SliceSize& size, double height) const {
    if (const auto* by_count = std::get_if<SliceCount>(&size)) return {1.0 * by_count->count, height / by_count->count};

    // Refuses slices that are finer than the fruit's coordinates resolve, and too many slices.
    const double thickness = std::get<SliceThickness>(size).metres;
    const double thinnest = thinnest_slice * glm::length(bounds_.size());
    const double min = std::fmax(thinnest, height / (max_slices - 3));
    const std::string hint = "take slices of at least " + in_millimetres(1.01 * min);
    if (thickness < thinnest) refuse_knife(laid_.text, "is thinner than the fruit resolves", hint);
    const double whole = std::floor(height / thickness * (1 + 1e-6));
    if (whole + 2 > max_slices) {
      refuse_knife(laid_.text, "makes more than " + std::to_string(max_slices) + " slices", hint);
    }
    return {whole, thickness};
  }

  /// The places of planes across this axis: whole slices are centred, with the rest at both ends.
  std::vector<double> slices_of(const SliceSize& size, int axis) const {
    const double height = bounds_.size()[axis];
    const auto [whole, thickness] = slicing(size, height);

    // Planes at the very ends cut nothing; bounds are floats, so ends are known to a millionth.
    std::vector<double> places;
    for (double i = 0; i <= whole; ++i) {
      const double place = bounds_.center()[axis] + (i - 0.5 * whole) * thickness;
      const bool is_end = place <= bounds_.low[axis] + 1e-6 * height || place >= bounds_.high[axis] - 1e-6 * height;
      if (!is_end) places.push_back(place);
    }
    return places;
  }

  void add_slices(const SliceSize& size, int axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    for (const double place : slices_of(size, axis)) {
      laid_.planes.push_back({normal, place});
      laid_.direction.push_back(static_cast<std::uint8_t>(axis));
    }
  }

  /// The planes of the strokes' edges; positive is to the right of a stroke.
  void add_strokes(std::vector<std::vector<glm::dvec2>> strokes) {
    laid_.strokes = std::move(strokes);
    for (const std::vector<glm::dvec2>& points : laid_.strokes) {
      const Stroke stroke(points);
      for (int i = 0; i < stroke.facets(); ++i) {
        const Stroke::Facet& f = stroke.facet(i);
        const glm::dvec3 normal(f.direction.y, -f.direction.x, 0);
        laid_.planes.push_back({normal, glm::dot(normal, glm::dvec3(f.start, 0))});
      }
    }
    laid_.across[0] = 1 + static_cast<int>(laid_.strokes.size());
  }

  KnifePlanes laid_;
  const Box<double>& bounds_;
};

}  // namespace

KnifePlanes planes_of(const Knife& knife, const Box<double>& bounds) {
  if (const auto* cut = std::get_if<PlaneCut>(&knife.cut)) {
    PlaneLayer layer(knife, bounds);
    std::visit(layer, *cut);
    return layer.finish();
  }
  KnifePlanes none;
  none.text = knife.text;
  none.across[0] = 2;  // everything lies in the first cell until the closed surface is placed
  return none;
}

KnifeSides KnifePlanes::seen(KnifeSides before, std::size_t plane, bool positive_side) const {
  if (plane == 0) before.first = positive_side;
  if (positive_side != (reversed[plane] != 0)) ++before.positive[direction[plane]];
  return before;
}

int KnifePlanes::cell(const KnifeSides& sides) const {
  if (wedges == 0) return sides.positive[0] + across[0] * (sides.positive[1] + across[1] * sides.positive[2]);

  // Counts sectors in the order of their angles. Each plane cuts the full turn in two places, so N planes make 2 N
  // sectors. On the first half turn one enters the planes' positive sides one by one; on the second half one leaves
  // them again.
  const int lines = static_cast<int>(planes.size());
  const int positive = sides.positive[0];
  const int sector = sides.first ? positive - 1 : 2 * lines - 1 - positive;

  // Where the number of wedges is odd, two sectors make one wedge.
  return wedges % 2 == 0 ? sector : sector / 2;
}

int KnifePlanes::cell_count() const { return wedges > 0 ? wedges : across[0] * across[1] * across[2]; }

}  // namespace pomona
