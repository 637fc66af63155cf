#include "generator/scene/settle/arrange.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/scene/settle/broad_phase.h"
#include "generator/scene/settle/contact.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/set_down.h"
#include "generator/scene/settle/upper_side.h"

namespace pomona {

namespace {

constexpr std::uint64_t draws_per_piece = 256;
constexpr glm::dvec3 upwards(0, 1, 0);

using Starts = std::vector<std::optional<StartPose>>;

/// A place of the arrangement's frame in the dish's frame.
glm::dvec3 in_dish(const PieceArrangement& how, double along, double across) {
  const double c = reproducible::cos(how.turn), s = reproducible::sin(how.turn);
  return {how.at.x + c * along + s * across, 0, how.at.y - s * along + c * across};
}

/// The rotation of a piece after it has fallen alone onto the ground from a random rotation.
glm::dquat at_rest(const ArrangedPiece& piece, const RandomStream& draw, std::uint64_t n,
                   const ArrangeOptions& options) {
  const Dish ground(DishForm{}, {.ground = 8 * options.widest});
  RigidBodyWorld alone(ground, 1, options.unit, options.widest, options.world, {1});
  const PieceShape& shape = *piece.shape;
  alone.put(0, RigidBody(shape, random_rotation(glm::dvec3(0), draw, n), glm::dvec3(0, 1.02 * shape.radius, 0)));
  alone.run_until_rest();
  return alone.bodies()[0].rotation;
}

glm::dquat attitude_of(const ArrangedPiece& piece, const RandomStream& draw, const ArrangeOptions& options) {
  const std::uint64_t n = draws_per_piece * piece.piece;
  const glm::dquat heading = turn_about(upwards, 2 * pi * draw.uniform(n + 8));
  if (piece.attitude == Attitude::upright) return heading;
  const glm::dvec3& face = piece.shape->up;
  if (piece.attitude == Attitude::face_up && face != glm::dvec3(0)) return heading * turn_between(face, upwards);
  return heading * at_rest(piece, draw, n, options);
}

/// All pieces at the origin, in the orientation in which they are to lie.
std::vector<RigidBody> turned(std::span<const ArrangedPiece> pieces, const RandomStream& draw,
                              const ArrangeOptions& options) {
  std::vector<RigidBody> bodies(pieces.size());
  parallel_for(pieces.size(), options.threads, [&](std::size_t i) {
    bodies[i] = RigidBody(*pieces[i].shape, attitude_of(pieces[i], draw, options), glm::dvec3(0));
  });
  return bodies;
}

/// The body on the dish, with the middle of its box above a place.
StartPose set_at(RigidBody body, const Solid& solid, const glm::dvec3& place, const Dish& dish) {
  const glm::dvec3 middle(tight_box(body).center());
  const double above = dish.rim_height() - static_cast<double>(body.box.low.y) + 0.01 * body.shape->size;
  body.center += glm::dvec3(place.x - middle.x, above, place.z - middle.z);
  body.refresh();
  set_down(body, dish, upwards);
  lift_out(body, solid, dish, upwards);
  return {body.rotation, body.center};
}

std::size_t columns_of(const PieceArrangement& how, std::size_t pieces) {
  if (how.columns > 0) return static_cast<std::size_t>(how.columns);
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(pieces))));
}

/// The size of the body along the arrangement's rows, and across them, metres.
glm::dvec2 extent(RigidBody body, const PieceArrangement& how) {
  body.rotation = turn_about(upwards, -how.turn) * body.rotation;
  body.refresh();
  const glm::dvec3 size = tight_box(body).size();
  return {size.x, size.z};
}

Starts in_rows(std::span<const ArrangedPiece> pieces, const std::vector<RigidBody>& bodies, const PieceArrangement& how,
               const Dish& dish, Threads threads) {
  // The length and the width of each row, metres.
  const std::size_t columns = columns_of(how, bodies.size());
  struct Row {
    double length = 0, width = 0;
  };
  std::vector<Row> rows((bodies.size() + columns - 1) / columns);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Row& row = rows[i / columns];
    const glm::dvec2 size = extent(bodies[i], how);
    row.length += size.x + (i % columns > 0 ? how.gap : 0);
    row.width = std::max(row.width, size.y);
  }
  double all = how.gap * static_cast<double>(rows.size() - 1);
  for (const Row& row : rows) all += row.width;

  // Each row is centred, and so are the rows.
  std::vector<glm::dvec3> places;
  double across = -0.5 * all, along = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Row& row = rows[i / columns];
    if (i % columns == 0) along = -0.5 * row.length;
    const double width = extent(bodies[i], how).x;
    places.push_back(in_dish(how, along + 0.5 * width, across + 0.5 * row.width));
    along += width + how.gap;
    if (i % columns + 1 == columns) across += row.width + how.gap;
  }
  Starts starts(bodies.size());
  parallel_for(bodies.size(), threads,
               [&](std::size_t i) { starts[i] = set_at(bodies[i], *pieces[i].solid, places[i], dish); });
  return starts;
}

Starts in_grid(std::span<const ArrangedPiece> pieces, const std::vector<RigidBody>& bodies, const PieceArrangement& how,
               const Dish& dish, Threads threads) {
  const std::size_t columns = columns_of(how, bodies.size()), rows = (bodies.size() + columns - 1) / columns;
  Starts starts(bodies.size());
  parallel_for(bodies.size(), threads, [&](std::size_t i) {
    const auto knot = [](std::size_t k, std::size_t count) {
      return static_cast<double>(k) - 0.5 * static_cast<double>(count - 1);
    };
    const glm::dvec3 place =
        in_dish(how, knot(i % columns, columns) * how.spacing.x, knot(i / columns, rows) * how.spacing.y);
    starts[i] = set_at(bodies[i], *pieces[i].solid, place, dish);
  });
  return starts;
}

/// Whether no part of it hangs over the border of the dish.
bool lies_within(const RigidBody& body, const Solid& solid, const Dish& dish) {
  return std::all_of(solid.mesh.position.begin(), solid.mesh.position.end(), [&](const glm::vec3& p) {
    return dish.covers(body.rotation * (glm::dvec3(p) - body.shape->center) + body.center);
  });
}

Starts scattered(std::span<const ArrangedPiece> pieces, const std::vector<RigidBody>& bodies,
                 const PieceArrangement& how, const Dish& dish, const RandomStream& draw,
                 const ArrangeOptions& options) {
  constexpr std::uint64_t max_tries = 60, before_tries = 16;
  const UpperSide upper(dish.mesh().mesh, dish.form());
  Starts starts(bodies.size());
  if (upper.empty()) return starts;
  std::vector<RigidBody> set = options.obstacles;
  BroadPhase near(2 * options.widest + how.gap, set.size() + bodies.size());
  for (std::size_t k = 0; k < set.size(); ++k) near.add(k, set[k].center);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::uint64_t n = draws_per_piece * pieces[i].piece + before_tries;
    for (std::uint64_t k = 0; k < max_tries && !starts[i]; ++k) {
      // The piece stands upright on the slope, a little above the random place; then it moves down onto it.
      const UpperSide::Spot spot =
          upper.spot(draw.uniform(n + 3 * k), draw.uniform(n + 3 * k + 1), draw.uniform(n + 3 * k + 2));
      RigidBody body = bodies[i];
      body.rotation = turn_between(upwards, spot.normal) * body.rotation;
      body.center = spot.at + spot.normal * body.shape->radius;
      body.refresh();
      set_down(body, dish, spot.normal);
      lift_out(body, *pieces[i].solid, dish, spot.normal);
      bool is_free = lies_within(body, *pieces[i].solid, dish);
      near.visit(body.center, [&](std::size_t other) {
        const auto gap = static_cast<float>(how.gap);
        is_free = is_free && distance_between(body, set[other], gap + 1e-6f) > gap;
      });
      if (!is_free) continue;
      near.add(set.size(), body.center);
      set.push_back(body);
      starts[i] = StartPose{body.rotation, body.center};
    }
  }
  return starts;
}

/// The direction across a fruit's slices: the normal of its largest cut face. Its sign is such that the first component
/// that is not zero, in the order y, x, z, is positive.
glm::dvec3 cutting_direction(std::span<const ArrangedPiece> pieces, const std::vector<std::size_t>& fruit) {
  double largest = -1;
  glm::dvec3 direction = upwards;
  for (const std::size_t i : fruit) {
    if (pieces[i].shape->up == glm::dvec3(0) || pieces[i].shape->size <= largest) continue;
    largest = pieces[i].shape->size;
    direction = pieces[i].shape->up;
  }
  for (const int axis : {1, 0, 2}) {
    if (std::fabs(direction[axis]) < 1e-3) continue;
    return direction[axis] < 0 ? -direction : direction;
  }
  return direction;
}

/// Each fruit lies along a line. Its pieces keep their order; they are pulled apart and lean backwards.
Starts in_order_of_cut(std::span<const ArrangedPiece> pieces, const PieceArrangement& how, const Dish& dish) {
  std::map<int, std::vector<std::size_t>> fruits;
  for (std::size_t i = 0; i < pieces.size(); ++i) fruits[pieces[i].fruit].push_back(i);
  double widest = 0;
  for (const ArrangedPiece& piece : pieces) widest = std::max(widest, 2 * piece.shape->radius);
  const double pitch = how.line > 0 ? how.line : widest + how.gap;
  const glm::dquat heading = turn_about(upwards, how.turn);
  const glm::dquat leaning = turn_about({0, 0, 1}, how.lean);

  Starts starts(pieces.size());
  double line = -0.5 * pitch * static_cast<double>(fruits.size() - 1);
  for (auto& [number, fruit] : fruits) {
    // The direction across the slices runs along the line.
    const glm::dvec3 direction = cutting_direction(pieces, fruit);
    const glm::dquat along = turn_between(direction, {1, 0, 0});
    std::stable_sort(fruit.begin(), fruit.end(), [&](std::size_t a, std::size_t b) {
      return glm::dot(pieces[a].shape->center, direction) < glm::dot(pieces[b].shape->center, direction);
    });

    // One piece behind the other. Their distances follow from the boxes of pieces that all lean by the same angle.
    std::vector<RigidBody> bodies;
    double length = 0;
    std::vector<double> middle;
    for (const std::size_t i : fruit) {
      const glm::dvec3 thickness = tight_box(RigidBody(*pieces[i].shape, along, glm::dvec3(0))).size();
      const double share = thickness.x / reproducible::cos(how.lean) + how.gap;
      bodies.emplace_back(*pieces[i].shape, leaning * along, glm::dvec3(0));
      middle.push_back(length + 0.5 * share);
      length += share;
    }
    for (std::size_t k = 0; k < fruit.size(); ++k) {
      const glm::dvec3 center = tight_box(bodies[k]).center();
      const glm::dvec3 place = in_dish(how, middle[k] - 0.5 * length - center.x, line - center.z);
      RigidBody body(*pieces[fruit[k]].shape, heading * bodies[k].rotation, {place.x, 0, place.z});
      body.center.y = dish.rim_height() - static_cast<double>(body.box.low.y) + 0.01 * body.shape->size;
      body.refresh();
      set_down(body, dish, upwards);
      starts[fruit[k]] = StartPose{body.rotation, body.center};
    }
    line += pitch;
  }
  return starts;
}

}  // namespace

bool has_upper_side(const Dish& dish) { return !UpperSide(dish.mesh().mesh, dish.form()).empty(); }

Starts arrange(std::span<const ArrangedPiece> pieces, const PieceArrangement& how, const Dish& dish,
               const RandomStream& draw, const ArrangeOptions& options) {
  if (pieces.empty() || how.kind == PieceArrangementKind::heap) return Starts(pieces.size());
  if (how.kind == PieceArrangementKind::as_cut) return in_order_of_cut(pieces, how, dish);
  const std::vector<RigidBody> bodies = turned(pieces, draw, options);
  if (how.kind == PieceArrangementKind::rows) return in_rows(pieces, bodies, how, dish, options.threads);
  if (how.kind == PieceArrangementKind::grid) return in_grid(pieces, bodies, how, dish, options.threads);
  return scattered(pieces, bodies, how, dish, draw, options);
}

}  // namespace pomona
