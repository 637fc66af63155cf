#include "tests/cut/cut_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/cut_observer.h"
#include "generator/surface/skin_depth.h"
#include "tests/cut/solid_shapes.h"
#include "tests/cut/without_overlaps.h"

namespace pomona::oracle {

namespace {

__extension__ using Quad = __float128;
using Point = std::array<Quad, 3>;

Point point_of(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
Quad dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The part of a triangle below the plane: nothing, or three or four corners in the triangle's order. A triangle in the
/// plane lies below if it faces up, because the solid behind it does.
std::vector<Point> below(const std::array<Point, 3>& t, const Point& normal, Quad offset) {
  std::array<Quad, 3> height{};
  for (std::size_t i = 0; i < 3; ++i) height[i] = dot(normal, t[i]) - offset;
  if (height[0] == 0 && height[1] == 0 && height[2] == 0) {
    const bool looks_up = dot(normal, cross(minus(t[1], t[0]), minus(t[2], t[0]))) > 0;
    return looks_up ? std::vector<Point>(t.begin(), t.end()) : std::vector<Point>();
  }
  std::vector<Point> part;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] <= 0) part.push_back(t[i]);
    if ((height[i] < 0 && height[j] > 0) || (height[i] > 0 && height[j] < 0)) {
      const Quad share = height[i] / (height[i] - height[j]);
      Point p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = t[i][k] + share * (t[j][k] - t[i][k]);
      part.push_back(p);
    }
  }
  return part;
}

/// Calls visit with every boundary triangle, turned so that it faces air.
template <typename Visit>
void for_each_skin(const DiffusionSurfaces& surfaces, const Visit& visit) {
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    const glm::uvec3& c = surfaces.triangle[t];
    std::array<Point, 3> corner{point_of(surfaces.position[c.x]), point_of(surfaces.position[c.y]),
                                point_of(surfaces.position[c.z])};
    if (surfaces.is_hidden(t, SideOf::back)) std::swap(corner[1], corner[2]);
    visit(corner);
  }
}

/// The area of the section on a plane's face.
double area_of(const Face& face, const Regions& regions) {
  double area = 0;
  for (std::size_t t = 0; t < face.triangle.size(); ++t) {
    const glm::uvec3& c = face.triangle[t];
    const glm::dvec3 across = glm::cross(face.place[c.y] - face.place[c.x], face.place[c.z] - face.place[c.x]);
    const double own = 0.5 * glm::dot(across, face.frame[face.facet[t]].normal);
    for (const Regions::Closing& closing : regions.closed_by(t)) {
      for (const BodyWinding& inside : closing.inside) area += inside.winding * own;
    }
  }
  return area;
}

/// Segments are directed by the fronts of their surfaces; around a body, surfaces whose back faces air run on against
/// that.
int open_ends(const std::vector<CutSegment>& segments, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  std::map<std::pair<std::int32_t, std::uint32_t>, int> balance;
  for (const CutSegment& s : segments) {
    const std::int32_t body = bodies.of_triangle[s.source];
    if (body == Bodies::none || !bodies.bodies[static_cast<std::size_t>(body)].closed) continue;
    const int way = surfaces.is_hidden(s.source, SideOf::back) ? -1 : 1;
    balance[{body, s.from}] += way;
    balance[{body, s.to}] -= way;
  }
  return static_cast<int>(std::count_if(balance.begin(), balance.end(), [](const auto& b) { return b.second != 0; }));
}

/// Keeps what is checked of a cut's stages.
class Witness final : public CutObserver {
 public:
  Witness(const DiffusionSurfaces& surfaces, const Bodies& bodies) : surfaces_(surfaces), bodies_(bodies) {}

  int open_chains = 0;
  CutPlanes planes;
  std::vector<double> area;  // per plane

  void sees(const CutPlanes& all_planes, const std::vector<std::vector<CutSegment>>& segments) override {
    planes = all_planes;
    area.assign(segments.size(), 0);
    for (const CutPlanes::Blade& blade : planes.blades) {
      std::vector<CutSegment> chains;  // chains of a stroke continue from facet to facet
      for (int k = blade.first; k < blade.first + blade.count; ++k) {
        const std::vector<CutSegment>& in_plane = segments[static_cast<std::size_t>(k)];
        chains.insert(chains.end(), in_plane.begin(), in_plane.end());
      }
      open_chains += open_ends(chains, surfaces_, bodies_);
    }
  }

  void sees(const CutPlanes&, const Cutting& cutting) override {
    for (std::size_t f = 0; f < cutting.faces.size(); ++f) {
      const auto plane = static_cast<std::size_t>(cutting.faces[f].plane);
      if (plane < area.size()) area[plane] = area_of(cutting.faces[f], cutting.regions[f]);
    }
  }

 private:
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
};

/// The skin of the fruit, or its bounding box where that is open.
ClosedSurface own_skin(const DiffusionSurfaces& surfaces) {
  const SkinDepth skin(surfaces);
  if (!skin.is_closed()) return shapes::block(bounds_of(surfaces).low, bounds_of(surfaces).high);
  ClosedSurface own;
  for (const TriangleTree::Corners& t : skin.skin().triangles()) {
    const auto first = static_cast<std::uint32_t>(own.point.size());
    own.point.insert(own.point.end(), t.begin(), t.end());
    own.triangle.emplace_back(first, first + 1, first + 2);
  }
  return own;
}

}  // namespace

// Where bodies are united, rounding folds some triangles over others. Such a skin is no knife: the skin as it was drawn
// is.
CutOracle::CutOracle(const DiffusionSurfaces& surfaces)
    : surfaces_(without_overlaps(surfaces)), own_skin_(own_skin(surfaces)), bodies_(find_bodies(surfaces_)) {
  size_ = glm::length(bounds_of(surfaces).size());
  for (const Bodies::Body& body : bodies_.bodies) {
    whole_ += body.volume;
    closed_ = closed_ && body.closed;
  }
}

double CutOracle::area_in(const CuttingPlane& plane) const {
  const Point normal = point_of(plane.normal);
  Quad up = 0;
  for_each_skin(surfaces_, [&](const std::array<Point, 3>& t) {
    const std::vector<Point> part = below(t, normal, plane.offset);
    for (std::size_t i = 2; i < part.size(); ++i) {
      up += dot(normal, cross(minus(part[i - 1], part[0]), minus(part[i], part[0])));
    }
  });
  return static_cast<double>(-up / 2);
}

double CutOracle::volume_below(const CuttingPlane& plane) const {
  const Point normal = point_of(plane.normal), origin = point_of(plane.normal * plane.offset);
  Quad volume = 0;
  for_each_skin(surfaces_, [&](const std::array<Point, 3>& t) {
    const std::vector<Point> part = below(t, normal, plane.offset);
    for (std::size_t i = 2; i < part.size(); ++i) {
      volume += dot(minus(part[0], origin), cross(minus(part[i - 1], origin), minus(part[i], origin)));
    }
  });
  return static_cast<double>(volume / 6);
}

/// The volume of the pieces on the plane's negative side.
double CutOracle::volume_below(std::span<const CutPiece> pieces, const CuttingPlane& plane) {
  double below = 0;
  for (const CutPiece& piece : pieces) {
    double farthest = 0;
    for (const glm::vec3& p : piece.position) {
      const double d = signed_distance(plane, glm::dvec3(p));
      if (std::fabs(d) > std::fabs(farthest)) farthest = d;
    }
    if (farthest < 0) below += piece.volume;
  }
  return below;
}

CutFacts CutOracle::facts_of_pieces(std::span<const CutPiece> pieces) const {
  CutFacts facts;
  double sum = 0;
  for (const CutPiece& piece : pieces) {
    ++facts.pieces;
    facts.open_pieces += closed_ && !piece.closed;
    sum += piece.volume;
  }
  if (closed_) facts.volume_error = std::fabs(sum - whole_) / whole_;
  return facts;
}

CutFacts CutOracle::facts(std::span<const Knife> knives) const {
  CutOptions options;
  options.coarsest = 0.2;
  options.finest = 0.05;
  options.threads = {1};
  Witness witness(surfaces_, bodies_);
  const Cut result = cut(surfaces_, knives, options, &witness);
  CutFacts facts = facts_of_pieces(result.pieces);
  facts.open_chains = witness.open_chains;
  if (!closed_) return facts;

  // Compare areas plane by plane, before closed knives.
  const CutPlanes& planes = witness.planes;
  for (int k = 0; k < planes.count(); ++k) {
    if (planes[k].same_as != k || planes.blade_of(k).stroke) continue;
    const double error = std::fabs(witness.area[static_cast<std::size_t>(k)] - area_in(planes[k].plane));
    facts.area_error = std::max(facts.area_error, error / (size_ * size_));
  }

  // Compare the volume below a single plane.
  if (planes.count() != 1 || knives.size() != 1) return facts;
  facts.side_error = std::fabs(volume_below(result.pieces, planes[0].plane) - volume_below(planes[0].plane)) / whole_;
  return facts;
}

namespace {

glm::dvec3 random_direction(const RandomStream& random, std::uint64_t draw) {
  const glm::dvec3 d(random.normal(draw), random.normal(draw + 1), random.normal(draw + 2));
  return glm::length(d) > 0 ? glm::normalize(d) : glm::dvec3(0, 1, 0);
}

Knife knife_at(const glm::dvec3& normal, double offset) { return {PlaneCut(PlaneKnife{{normal, offset}})}; }

constexpr std::uint64_t draws = 16;         // per plane
constexpr std::uint64_t stroke_draws = 64;  // per stroke

}  // namespace

glm::dvec3 CutOracle::corner(const RandomStream& random, std::uint64_t draw) const {
  const glm::uvec3& t = surfaces_.triangle[random.below(draw, surfaces_.triangle_count())];
  return glm::dvec3(surfaces_.position[t[static_cast<int>(random.below(draw + 1, 3))]]);
}

Knife CutOracle::random_plane(const RandomStream& random, std::uint64_t number) const {
  const Box<double> bounds = bounds_of(surfaces_);
  const std::uint64_t draw = draws * number;
  glm::dvec3 place(0);
  for (int i = 0; i < 3; ++i) {
    place[i] = bounds.low[i] + random.uniform(draw + static_cast<std::uint64_t>(i)) * bounds.size()[i];
  }
  const glm::dvec3 normal = random_direction(random, draw + 3);
  return knife_at(normal, glm::dot(normal, place));
}

Knife CutOracle::degenerate_plane(const RandomStream& random, std::uint64_t number) const {
  const std::uint64_t draw = draws * number;
  const glm::uvec3& triangle = surfaces_.triangle[random.below(draw, surfaces_.triangle_count())];
  const glm::dvec3 a(surfaces_.position[triangle.x]), b(surfaces_.position[triangle.y]),
      c(surfaces_.position[triangle.z]);
  glm::dvec3 normal = random_direction(random, draw + 1), level(0);
  const int axis = static_cast<int>(random.below(draw + 5, 3));
  level[axis] = 1;

  switch (number % 6) {
    case 0:
      return knife_at(normal, glm::dot(normal, a));
    case 1:
      return knife_at(level, a[axis]);
    case 2:
      normal = glm::cross(b - a, normal);
      break;
    case 3:
      normal = glm::cross(b - a, c - a);
      break;
    case 4: {
      double farthest = glm::dot(normal, a);
      for (const glm::uvec3& t : surfaces_.triangle) {
        farthest = std::max(farthest, glm::dot(normal, glm::dvec3(surfaces_.position[t.x])));
      }
      return knife_at(normal, farthest);
    }
    default: {
      const Box<double> bounds = bounds_of(surfaces_);
      return knife_at(level, (random.below(draw + 6, 2) == 0 ? bounds.low : bounds.high)[axis]);
    }
  }
  const double length = glm::length(normal);
  normal = length > 0 ? normal / length : level;
  return knife_at(normal, glm::dot(normal, a));
}

Knife CutOracle::random_stroke(const RandomStream& random, std::uint64_t number) const {
  const std::uint64_t draw = stroke_draws * number;
  const Box<double> bounds = bounds_of(surfaces_);
  glm::dvec2 way(random_direction(random, draw));
  way = glm::length(way) > 0 ? glm::normalize(way) : glm::dvec2(1, 0);

  // A line that advances along one direction cannot cross itself.
  std::vector<glm::dvec2> corners;
  const std::uint64_t count = 2 + random.below(draw + 3, 19);
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::dvec3 share(random.uniform(draw + 5 + 2 * i), random.uniform(draw + 6 + 2 * i), 0);
    corners.emplace_back(number % 2 == 0 ? bounds.low + share * bounds.size() : corner(random, draw + 5 + 2 * i));
  }
  std::sort(corners.begin(), corners.end(), [&](const glm::dvec2& a, const glm::dvec2& b) {
    return std::pair(glm::dot(way, a), a.x) < std::pair(glm::dot(way, b), b.x);
  });
  std::vector<glm::dvec2> stroke;
  const double apart = 0.01 * glm::length(bounds.size());
  for (const glm::dvec2& p : corners) {
    if (stroke.empty() || glm::dot(way, p - stroke.back()) > apart) stroke.push_back(p);
  }
  if (stroke.size() == 1) stroke.push_back(stroke[0] + apart * way);
  return {PlaneCut(StrokeKnife{cleaned(stroke)})};  // as those that are read
}

Knife CutOracle::random_solid(const RandomStream& random, std::uint64_t number) const {
  const std::uint64_t draw = draws * number;
  const Box<double> bounds = bounds_of(surfaces_);
  const auto share = [&](std::uint64_t i) { return random.uniform(draw + i); };
  const glm::dvec3 place = bounds.low + glm::dvec3(share(0), share(1), share(2)) * bounds.size();
  const double size = (0.1 + 0.4 * share(3)) * size_;
  const glm::dvec3 vertex = corner(random, draw + 4);
  using shapes::solid_knife;
  switch (number % 9) {
    case 0:
      return solid_knife(shapes::ball(place, size, 4));
    case 1:
      return solid_knife(shapes::block(place - 0.5 * size, place + 0.5 * size));
    case 2:
      return solid_knife(shapes::rod(place, 0.5 * size, size, 12));
    case 3:
      return solid_knife(shapes::ball(vertex - glm::dvec3(size, 0, 0), size, 4));  // its tip is a vertex of the fruit
    case 4:
      return solid_knife(shapes::block(vertex, vertex + size));  // its corner is
    case 5: {
      const glm::dvec3 beside(bounds.low.x, place.y, place.z);
      return solid_knife(shapes::block(beside, beside + size));
    }
    case 6:
      return solid_knife(shapes::block(bounds.low, bounds.high));
    case 7:
      return solid_knife(shapes::rod(glm::dvec3(vertex.x - 0.5 * size, vertex.y, vertex.z), 0.5 * size, size, 8));
    default:
      return solid_knife(own_skin_);
  }
}

}  // namespace pomona::oracle
