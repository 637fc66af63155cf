#include "generator/scene/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/stand_profile.h"

namespace pomona {

namespace {

/// What the physics and the measuring need to know of a solid; made once, however often it is placed.
struct Shape {
  TriangleTree mesh;
  std::vector<ConvexPart> parts;
  glm::dvec3 center_of_mass{0};
  glm::dvec3 middle{0};  ///< of its box
  double size = 0;       ///< diagonal of its box
  double radius = 0;     ///< of the ball around its middle
  double mass = 0;
  glm::dvec3 up{0};
};

/// Centre of mass and volume of a closed mesh: tetrahedra to its middle, summed with their signs.
void weigh(Shape& shape) {
  double six_volumes = 0;
  glm::dvec3 moment(0);
  for (const TriangleTree::Corners& t : shape.mesh.triangles()) {
    const glm::dvec3 a = t[0] - shape.middle, b = t[1] - shape.middle, c = t[2] - shape.middle;
    const double v = glm::dot(a, glm::cross(b, c));
    six_volumes += v;
    moment += (a + b + c) * (0.25 * v);
  }
  const double ball = shape.size * shape.size * shape.size;
  shape.center_of_mass = shape.middle;
  shape.mass = std::max(six_volumes / 6, 1e-3 * ball);
  if (six_volumes / 6 > 1e-3 * ball) shape.center_of_mass += moment / six_volumes;
}

/// The direction that the largest cut face looks; zero where there is none.
glm::dvec3 largest_face(const Solid& solid) {
  std::map<std::int32_t, glm::dvec3> areas;
  for (std::size_t i = 0; i < solid.triangle.size(); ++i) {
    if (i >= solid.cut_face.size() || solid.cut_face[i] < 0) continue;
    const glm::uvec3& t = solid.triangle[i];
    const glm::dvec3 a(solid.position[t.x]), b(solid.position[t.y]), c(solid.position[t.z]);
    areas.try_emplace(solid.cut_face[i], 0.0).first->second += glm::cross(b - a, c - a);
  }
  glm::dvec3 best(0);
  for (const auto& [face, area] : areas)
    if (glm::dot(area, area) > glm::dot(best, best)) best = area;
  return best == glm::dvec3(0) ? best : glm::normalize(best);
}

Shape shape_of(const Solid& solid, const ConvexPartsOptions& options) {
  Shape shape;
  shape.mesh = TriangleTree(solid.position, solid.triangle);
  shape.parts = convex_parts(shape.mesh, options);
  shape.middle = 0.5 * (shape.mesh.box().low + shape.mesh.box().high);
  shape.size = glm::distance(shape.mesh.box().low, shape.mesh.box().high);
  for (const TriangleTree::Corners& t : shape.mesh.triangles())
    for (const glm::dvec3& corner : t) shape.radius = std::max(shape.radius, glm::distance(corner, shape.middle));
  shape.up = largest_face(solid);
  weigh(shape);
  return shape;
}

/// The bowl and the ground it stands on as one mesh, and the opening that pieces go through.
struct Table {
  PlacedMesh stand;
  std::vector<glm::dvec2> profile;
  double rim_radius = 0, rim_height = 0;
};

Table laid_table(const Solid* bowl, double reach) {
  Table table;
  double widest = 0;
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;
  if (bowl) {
    position = bowl->position;
    triangle = bowl->triangle;
    for (const glm::vec3& p : position) {
      const double radius = std::sqrt(double(p.x) * p.x + double(p.z) * p.z);
      widest = std::max(widest, radius);
      if (p.y > table.rim_height) table.rim_height = p.y, table.rim_radius = radius;
    }
  }

  // The ground: a slab with its upper face at y = 0.
  const auto first = static_cast<unsigned>(position.size());
  const float wide = static_cast<float>(std::max(4 * table.rim_radius, reach)), deep = -0.25f * wide;
  for (const float y : {deep, 0.0f})
    for (const glm::vec2& xz : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
      position.emplace_back(xz.x * wide, y, xz.y * wide);
  for (const glm::uvec3& t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3), glm::uvec3(4, 6, 5), glm::uvec3(4, 7, 6)})
    triangle.push_back(t + first);
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) % 4;
    triangle.push_back(glm::uvec3(i, 4 + i, j) + first);
    triangle.push_back(glm::uvec3(j, 4 + i, 4 + j) + first);
  }
  table.stand.mesh = TriangleTree(position, triangle);
  const double seen = bowl ? 1.02 * widest : wide;
  table.profile = stand_profile(table.stand.mesh, seen, 1.2e-3 * (bowl ? table.rim_radius : wide));
  table.stand.size = bowl ? 2 * table.rim_radius : wide;
  return table;
}

double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

Pose rounded(Pose pose) {
  const glm::dquat q = pose.rotation.w < 0 ? -pose.rotation : pose.rotation;
  pose.rotation = glm::dquat(rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z));
  for (int k = 0; k < 3; ++k) pose.translation[k] = rounded(pose.translation[k]);
  return pose;
}

/// One attempt's result, and what is wrong with it.
struct Attempt {
  Settled settled;
  std::vector<std::string> faults;
};

class Settling {
 public:
  Settling(std::span<const Solid> solids, std::span<const SettleItem> items, const Solid* bowl,
           const SettleOptions& options)
      : items_(items), options_(options) {
    // Only solids that are placed are worth the work.
    std::vector<std::uint8_t> used(solids.size());
    for (const SettleItem& item : items) used[static_cast<std::size_t>(item.solid)] = 1;
    shapes_.resize(solids.size());
    parallel_for(solids.size(), options.threads, [&](std::size_t i) {
      if (used[i]) shapes_[i] = shape_of(solids[i], options.parts);
    });
    double reach = 0;
    for (const SettleItem& item : items) reach += shape(item).size;
    table_ = laid_table(bowl, reach);
  }

  Attempt attempt(int number) const {
    Attempt result;
    const Piled piled = fallen(number);
    result.settled.steps = piled.steps;

    // Turn the real meshes as the bodies lie, then bring them into contact.
    std::vector<PlacedMesh> placed(items_.size());
    parallel_for(items_.size(), options_.threads, [&](std::size_t i) {
      const Pose pose = rounded(piled.poses[i]);
      placed[i] = {shape(items_[i]).mesh.rotated(pose.rotation), pose.translation, shape(items_[i]).size};
    });
    const std::vector<glm::dvec3> places = seat(placed, table_.stand, options_.seat, options_.threads);

    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Pose pose = rounded(Pose{piled.poses[i].rotation, places[i]});
      placed[i].at = pose.translation;
      result.settled.poses.push_back(pose);
    }
    result.settled.fits = measure_fits(placed, table_.stand, options_.threads);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const std::string fault = fault_of(result.settled.fits[i], placed[i], items_[i]);
      if (!fault.empty()) result.faults.push_back("piece \"" + items_[i].name + "\" " + fault);
    }
    if (!piled.at_rest) result.faults.push_back("the pile is still moving");
    return result;
  }

 private:
  const Shape& shape(const SettleItem& item) const { return shapes_[static_cast<std::size_t>(item.solid)]; }

  Piled fallen(int number) const {
    // Where each piece begins to fall is drawn anew for each attempt.
    std::vector<DropPiece> drops;
    for (const SettleItem& item : items_) {
      const Shape& s = shape(item);
      drops.push_back({s.parts, item.face_up ? s.up : glm::dvec3(0), item.order, item.beside});
    }
    const RandomStream draw({options_.seed, static_cast<std::uint64_t>(number)}, "scene/drop");
    const DropSpace space = drop_space();
    const std::vector<Pose> starts = drop_poses(drops, space, draw);

    // The bodies start there; if there is a bowl, a wall keeps them over it.
    std::vector<PileBody> bodies;
    const Funnel funnel{table_.rim_height > 0 ? space.radius : 0, 0.9 * table_.rim_height};
    double sizes = 0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Shape& s = shape(items_[i]);
      bodies.push_back({s.parts, s.center_of_mass, s.mass, starts[i]});
      sizes += s.size;
    }

    // Unless a unit is given, it is the mean size of the bodies.
    PileOptions pile_options = options_.pile;
    if (pile_options.unit <= 0 && !items_.empty()) pile_options.unit = sizes / double(items_.size());
    return pile(bodies, table_.profile, funnel, pile_options);
  }

  DropSpace drop_space() const {
    double widest = 0;
    for (const SettleItem& item : items_) widest = std::max(widest, shape(item).radius);
    const double spread = options_.spread > 0 ? options_.spread : 4 * widest;
    const double open = table_.rim_height > 0 ? options_.fill * table_.rim_radius : spread;
    return {open, table_.rim_height, options_.around * std::max(table_.rim_radius, 2 * widest)};
  }

  std::string fault_of(const Fit& fit, const PlacedMesh& placed, const SettleItem& item) const {
    char text[96] = "";
    if (fit.gap > options_.most_gap)
      std::snprintf(text, sizeof text, "keeps a gap of %.1f %% of its size", 100 * fit.gap);
    if (fit.penetration > options_.most_penetration)
      std::snprintf(text, sizeof text, "overlaps by %.1f %% of its size", 100 * fit.penetration);
    if (text[0] == '\0' && table_.rim_height > 0 && !item.beside && is_outside(placed)) return "lies outside the bowl";
    return text;
  }

  /// Beyond the rim, or under the bowl.
  bool is_outside(const PlacedMesh& placed) const {
    for (const TriangleTree::Corners& t : placed.mesh.triangles()) {
      for (const glm::dvec3& corner : t) {
        const glm::dvec3 p = corner + placed.at;
        if (p.x * p.x + p.z * p.z > table_.rim_radius * table_.rim_radius || p.y < 0) return true;
      }
    }
    const glm::dvec3 middle = 0.5 * (placed.mesh.box().low + placed.mesh.box().high) + placed.at;
    return table_.stand.mesh.height_below(middle) <= 0;
  }

  std::span<const SettleItem> items_;
  SettleOptions options_;
  std::vector<Shape> shapes_;
  Table table_;
};

[[noreturn]] void give_up(const Attempt& attempt) {
  constexpr std::size_t most_listed = 5;
  std::string message = "the pieces do not settle: " + attempt.faults.front();
  for (std::size_t i = 1; i < std::min(attempt.faults.size(), most_listed); ++i) message += "; " + attempt.faults[i];
  if (attempt.faults.size() > most_listed)
    message += "; and " + std::to_string(attempt.faults.size() - most_listed) + " more";
  throw Error(ExitStatus::some_items_failed, message, "a wider bowl, fewer pieces or another seed may help");
}

}  // namespace

Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const Solid* bowl,
               const SettleOptions& options) {
  if (items.empty()) return {};
  const Settling settling(solids, items, bowl, options);
  // Physics runs on one thread: let as many attempts fall at a time as there are threads, and take the first that
  // fits, whichever was done first.
  const int most = std::max(1, options.attempts);
  const int at_a_time = std::min(most, resolved(options.threads));
  Attempt best;
  for (int first = 0; first < most; first += at_a_time) {
    std::vector<Attempt> attempts(static_cast<std::size_t>(std::min(at_a_time, most - first)));
    parallel_for(attempts.size(), options.threads,
                 [&](std::size_t i) { attempts[i] = settling.attempt(first + static_cast<int>(i)); });
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      Attempt& attempt = attempts[i];
      attempt.settled.attempts = first + static_cast<int>(i) + 1;
      if (attempt.faults.empty()) return std::move(attempt.settled);
      if (first + i == 0 || attempt.faults.size() < best.faults.size()) best = std::move(attempt);
    }
  }
  give_up(best);
}

}  // namespace pomona
