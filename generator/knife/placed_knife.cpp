#include "generator/knife/placed_knife.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/millimetres.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/knife/stroke.h"

namespace pomona {

namespace {

constexpr double thinnest_slice = 1e-4;  // share of the fruit's diagonal

/// Cosine and sine with the zeros and ones of quarter turns exact, so that such planes lie on the axes.
glm::dvec2 direction(double angle) {
  glm::dvec2 d(reproducible::cos(angle), reproducible::sin(angle));
  for (int i = 0; i < 2; ++i) {
    if (std::fabs(d[i]) < 1e-15) d[i] = 0;
    if (std::fabs(std::fabs(d[i]) - 1) < 1e-15) d[i] = d[i] < 0 ? -1 : 1;
  }
  return d;
}

/// Half-planes at 2 pi k / N as whole planes in the order of their angle; where N is odd, every other plane serves the
/// half-plane behind the axis and is turned so that its normal still points to growing angles there.
void place_wedges(PlacedKnife& placed, int count) {
  const int lines = count % 2 == 0 ? count / 2 : count;
  placed.pencil = true;
  for (int i = 0; i < lines; ++i) {
    const glm::dvec2 d = direction(pi * i / lines);
    const bool reversed = count % 2 == 1 && i % 2 == 1;
    const glm::dvec3 normal(-d.y, 0, -d.x);
    placed.planes.push_back({reversed ? -normal : normal, 0});
    placed.reversed.push_back(reversed ? 1 : 0);
  }
}

/// Planes across one axis. By count: equal slices. By thickness: as many whole slices as fit, centred, and the rest at
/// both ends.
void place_slices(PlacedKnife& placed, const Knife& knife, const Box<double>& bounds, int axis) {
  const double height = bounds.size()[axis];
  double thickness = knife.thickness;
  double whole = knife.count;
  if (knife.count > 0) {
    thickness = height / knife.count;
  } else {
    const double least = std::fmax(thinnest_slice * glm::length(bounds.size()), height / (most_slices - 3));
    const std::string hint = "take slices of at least " + in_millimetres(1.01 * least);
    if (thickness < thinnest_slice * glm::length(bounds.size())) {
      refuse_knife(knife.text, "is thinner than the fruit resolves", hint);
    }
    whole = std::floor(height / thickness * (1 + 1e-6));
    if (whole + 2 > most_slices)
      refuse_knife(knife.text, "makes more than " + std::to_string(most_slices) + " slices", hint);
  }

  // Planes at the very ends cut nothing; bounds are floats, so ends are known to a millionth.
  for (double i = 0; i <= whole; ++i) {
    const double y = bounds.center()[axis] + (i - 0.5 * whole) * thickness;
    if (y <= bounds.low[axis] + 1e-6 * height || y >= bounds.high[axis] - 1e-6 * height) continue;
    glm::dvec3 normal(0);
    normal[axis] = 1;
    placed.planes.push_back({normal, y});
    placed.direction.push_back(static_cast<std::uint8_t>(axis));
  }
}

constexpr int most_facets = 8192;

/// The planes of the strokes' edges; positive is to the right of a stroke.
void place_strokes(PlacedKnife& placed, std::vector<std::vector<glm::dvec2>> strokes) {
  placed.strokes = std::move(strokes);
  for (const std::vector<glm::dvec2>& points : placed.strokes) {
    const Stroke stroke(points);
    for (int i = 0; i < stroke.facets(); ++i) {
      const Stroke::Facet& f = stroke.facet(i);
      const glm::dvec3 normal(f.direction.y, -f.direction.x, 0);
      placed.planes.push_back({normal, glm::dot(normal, glm::dvec3(f.start, 0))});
    }
  }
  placed.across[0] = 1 + static_cast<int>(placed.strokes.size());
}

void place_stroke(PlacedKnife& placed, const Knife& knife, const Box<double>& bounds) {
  if (crosses_itself(knife.stroke, glm::dvec2(bounds.center()), glm::length(bounds.size()))) {
    refuse_knife(knife.text, "crosses itself where its ends go on straight", "draw its ends on beyond the fruit");
  }
  place_strokes(placed, {knife.stroke});
}

/// Slices between waves that run along x. A wave is as long as a slice is thick, and a quarter as high.
void place_crinkle(PlacedKnife& placed, const Knife& knife, const Box<double>& bounds) {
  constexpr int steps = 8;  // of a wave
  PlacedKnife level;
  place_slices(level, knife, bounds, 1);
  const double wave = knife.thickness, height = wave / 8;
  const double waves = std::ceil(0.5 * bounds.size().x / wave) + 1;
  if (2 * waves * steps * static_cast<double>(level.planes.size()) > most_facets) {
    refuse_knife(knife.text, "makes more than " + std::to_string(most_facets) + " facets", "take thicker slices");
  }
  std::vector<std::vector<glm::dvec2>> strokes;
  for (const CuttingPlane& plane : level.planes) {
    std::vector<glm::dvec2> points;
    for (double i = waves * steps; i >= -waves * steps; --i) {
      const double x = bounds.center().x + i / steps * wave;
      points.emplace_back(x, plane.offset + height * reproducible::sin(2 * pi * i / steps));
    }
    strokes.push_back(cleaned(points));  // where a wave turns from left to right its edges are in line
  }
  place_strokes(placed, std::move(strokes));
}

}  // namespace

PlacedKnife placed(const Knife& knife, const Box<double>& bounds) {
  PlacedKnife placed;
  placed.knife = knife;
  switch (knife.kind) {
    case Knife::Kind::plane:
      placed.planes.push_back(knife.plane);
      break;
    case Knife::Kind::half:
      placed.planes.push_back({{0, 0, 1}, 0});
      break;
    case Knife::Kind::across:
      placed.planes.push_back({{0, 1, 0}, bounds.center().y});
      break;
    case Knife::Kind::wedges:
      place_wedges(placed, knife.count);
      break;
    case Knife::Kind::slices:
      place_slices(placed, knife, bounds, 1);
      break;
    case Knife::Kind::dice:
      for (int axis = 0; axis < 3; ++axis) place_slices(placed, knife, bounds, axis);
      break;
    case Knife::Kind::sticks:
      place_slices(placed, knife, bounds, 0);
      place_slices(placed, knife, bounds, 2);
      break;
    case Knife::Kind::stroke:
      place_stroke(placed, knife, bounds);
      break;
    case Knife::Kind::crinkle:
      place_crinkle(placed, knife, bounds);
      break;
    case Knife::Kind::ball:
    case Knife::Kind::core:
    case Knife::Kind::bite:
    case Knife::Kind::revolve:
    case Knife::Kind::peel:
    case Knife::Kind::surface:  // no planes (solid_knives.h); until it is laid on, all is in the first of two cells
      placed.across[0] = 2;
      break;
  }
  placed.reversed.resize(placed.planes.size(), 0);
  placed.direction.resize(placed.planes.size(), 0);
  if (placed.strokes.empty()) {
    for (const std::uint8_t d : placed.direction) ++placed.across[d];
  }
  return placed;
}

KnifeSides PlacedKnife::seen(KnifeSides before, std::size_t plane, bool positive_side) const {
  if (plane == 0) before.first = positive_side;
  if (positive_side != (reversed[plane] != 0)) ++before.positive[direction[plane]];
  return before;
}

int PlacedKnife::cell(const KnifeSides& sides) const {
  if (!pencil) return sides.positive[0] + across[0] * (sides.positive[1] + across[1] * sides.positive[2]);

  // The planes, in the order of their angles, cut the turn into two sectors each. Going round, the first half turn
  // enters their positive sides one by one, the second half leaves them.
  const int lines = static_cast<int>(planes.size());
  const int positive = sides.positive[0];
  const int sector = sides.first ? positive - 1 : 2 * lines - 1 - positive;
  return knife.count % 2 == 0 ? sector : sector / 2;
}

int PlacedKnife::cell_count() const { return pencil ? knife.count : across[0] * across[1] * across[2]; }

}  // namespace pomona
