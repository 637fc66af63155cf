#include "generator/scene/table_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/scene/piece_outline.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/side_areas.h"

namespace pomona {

namespace {

constexpr double degree = pi / 180;
constexpr double eye_height = 48 * degree;  // above the table
constexpr double low_eye_height = 24 * degree;
constexpr double diagonal_angle = 50 * degree;  // to the right of straight away from the eye
constexpr double lean_angle = 12 * degree;      // angle by which pieces on a rounded back lean towards the eye
constexpr double slender_ratio = 1.8;           // ratio of length to width from which pieces are slender

glm::dvec3 turned_about(const glm::dvec3& axis, double angle, const glm::dvec3& v) {
  const double c = reproducible::cos(angle), s = reproducible::sin(angle);
  return c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

struct CutSide {
  glm::dvec3 normal{0};
  double area = 0;
  bool flat = false;
  std::int32_t cut = 0;  // number of the cut face
};

/// The directions of cut faces, largest first, at most eight. A ball's hollow faces where its rim does.
std::vector<CutSide> cut_sides(const Solid& solid) {
  std::map<std::int32_t, std::pair<glm::dvec3, double>> face;  // area vector, and area
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (solid.mesh.cut_face[t] < 0) continue;
    const glm::dvec3 vector = 0.5 * solid.mesh.area_vector(t);
    auto& [sum, area] = face.try_emplace(solid.mesh.cut_face[t], glm::dvec3(0), 0.0).first->second;
    sum += vector;
    area += glm::length(vector);
  }
  std::vector<CutSide> sides;
  for (const auto& [index, of] : face) {
    const double facing = glm::length(of.first);
    if (facing > 0.3 * of.second && facing > 0)
      sides.push_back({of.first / facing, facing, facing > 0.98 * of.second, index});
  }
  std::stable_sort(sides.begin(), sides.end(), [](const CutSide& a, const CutSide& b) { return a.area > b.area; });
  constexpr std::size_t max = 8;
  if (sides.size() > max) sides.resize(max);
  return sides;
}

/// A candidate pose.
struct Rest {
  glm::dvec3 up{0, 1, 0};
  bool on_flat = false;   ///< on a flat cut face
  bool as_grown = false;  ///< it stands as it grew
};

/// The length of a cut face in one direction.
double length_of_face(const Solid& solid, std::int32_t cut, const glm::dvec3& along) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (solid.mesh.cut_face[t] != cut) continue;
    for (int corner = 0; corner < 3; ++corner) {
      const double at = glm::dot(glm::dvec3(solid.mesh.position[solid.mesh.triangle[t][corner]]), along);
      least = std::min(least, at);
      most = std::max(most, at);
    }
  }
  return std::max(0.0, most - least);
}

std::vector<Rest> ways_to_rest(const PieceOutline& outline, const std::vector<CutSide>& sides) {
  std::vector<Rest> ways;
  const auto add = [&](const glm::dvec3& start) {
    Rest rest{outline.rested(start)};
    for (const CutSide& side : sides) {
      if (!side.flat || glm::dot(rest.up, -side.normal) < 0.997) continue;
      rest = {-side.normal, true, false};
      break;
    }
    // On a round back a few degrees are invisible: the largest face is then level, whichever end is heavier.
    if (!rest.on_flat && !sides.empty() && glm::dot(rest.up, sides[0].normal) > 0.85) rest.up = sides[0].normal;
    ways.push_back(rest);
  };
  glm::dvec3 together(0);
  for (const CutSide& side : sides) {
    add(side.normal);
    add(-side.normal);
    together += side.area * side.normal;
  }
  if (!sides.empty() && glm::length(together) > 0.2 * sides[0].area) add(glm::normalize(together));
  return ways;
}

/// Turns on the spot: the piece's own level direction that will face the eye.
std::vector<glm::dvec3> ways_to_turn(const glm::dvec3& up, const PieceOutline::Plan& plan) {
  std::vector<glm::dvec3> fronts;
  if (plan.ratio > slender_ratio) {
    // A piece along the diagonal turns its side to the eye: the front is `along` turned back by the diagonal.
    for (const double sign : {1.0, -1.0}) fronts.push_back(turned_about(up, diagonal_angle + pi, sign * plan.along));
    return fronts;
  }
  const glm::dvec3 first = level_direction(up);
  for (int i = 0; i < 24; ++i) fronts.push_back(turned_about(up, (15 * i + 180) * degree, first));
  return fronts;
}

/// The rotation that takes `up` to +Y and `front`, level, to +Z.
glm::dquat standing_frame(const glm::dvec3& up, const glm::dvec3& front) {
  const glm::dmat3 own(glm::cross(up, front), up, front);
  return glm::normalize(glm::quat_cast(glm::transpose(own)));
}

struct PoseChoice {
  Rest rest;
  glm::dvec3 front{0, 0, 1};
  bool slender = false;
  double score = -1;
};

/// Chooses among poses by how much is visible.
class Chooser {
 public:
  Chooser(const Solid& solid, const glm::dvec3& eye)
      : solid_(solid),
        eye_(eye),
        outline_(solid),
        areas_(solid),
        sides_(cut_sides(solid)),
        has_ground_(stands_on_flat_ground(solid)) {}

  PoseChoice choose() const {
    PoseChoice best;
    if (has_ground_ || is_hardly_cut()) {
      try_all(as_it_grew(), best);
      return best;
    }
    for (const Rest& rest : ways_to_rest(outline_, sides_)) try_all(rest, best);
    if (best.score < 0) try_all(as_it_grew(), best);
    return best;
  }

  /// The pose as it grew, standing; nothing for pieces with flat cuts.
  PoseChoice choose_standing() const {
    PoseChoice best;
    const auto is_wide = [&](const CutSide& side) { return side.flat && side.area > 0.15 * areas_.cut(); };
    if (std::none_of(sides_.begin(), sides_.end(), is_wide)) try_all({{0, 1, 0}, false, true}, best);
    return best;
  }

  /// To where the largest cut face looks, if it is flat.
  glm::dvec3 flat_face() const { return !sides_.empty() && sides_[0].flat ? sides_[0].normal : glm::dvec3(0); }

  /// Whether the piece lies on its back, and its largest cut face looks up.
  bool on_its_back(const Rest& rest) const {
    return !rest.as_grown && !rest.on_flat && !sides_.empty() && glm::dot(sides_[0].normal, rest.up) > 0.8;
  }

 private:
  /// Pieces that were bitten, cored or lost their tip; but not half a star fruit, whose cut is small, too, nor half a
  /// cabbage, of which a knife meets the edges of leaves alone.
  bool is_hardly_cut() const {
    const auto is_wide = [&](const CutSide& side) {
      return side.flat && (side.area > 0.04 * areas_.skin() || goes_through(side));
    };
    return areas_.cut() < 0.25 * areas_.skin() && std::none_of(sides_.begin(), sides_.end(), is_wide);
  }

  /// Whether a cut face is about as long and wide as the piece.
  bool goes_through(const CutSide& side) const {
    const glm::dvec3 along = level_direction(side.normal), across = glm::cross(side.normal, along);
    const auto share = [&](const glm::dvec3& way) {
      return length_of_face(solid_, side.cut, way) / (outline_.height(way) + outline_.height(-way));
    };
    return share(along) > 0.7 && share(across) > 0.7;
  }

  /// Upright; a piece that is long, or would stand on its root, lies down, unless it has a flat bottom.
  Rest as_it_grew() const {
    Rest rest{.up = {0, 1, 0}, .on_flat = false, .as_grown = true};
    const double sideways = std::min(outline_.height({1, 0, 0}) + outline_.height({-1, 0, 0}),
                                     outline_.height({0, 0, 1}) + outline_.height({0, 0, -1}));
    const double upright = outline_.height({0, 1, 0}) + outline_.height({0, -1, 0});
    if (!has_ground_ && (upright > 2 * sideways || stands_on_a_tail(solid_))) rest.up = outline_.rested({0, 0, 1});
    return rest;
  }

  /// The level direction closest to its growth: pieces that lie down lie along it, whatever their shape.
  static glm::dvec3 along_the_axis(const glm::dvec3& up) {
    constexpr glm::dvec3 axis(0, 1, 0);
    return glm::normalize(axis - glm::dot(axis, up) * up);
  }

  void try_all(const Rest& rest, PoseChoice& best) const {
    PieceOutline::Plan plan = outline_.plan(rest.up);
    // Standing pieces turn their faces to the eye, however wide they are.
    if (rest.as_grown && has_ground_) plan.ratio = 1;
    if (rest.as_grown && rest.up.y < 0.5) plan = {along_the_axis(rest.up), std::max(plan.ratio, 2 * slender_ratio)};
    const bool slender = plan.ratio > slender_ratio;
    for (const glm::dvec3& front : ways_to_turn(rest.up, plan)) {
      const double score = score_of(rest, front);
      if (score > best.score * (1 + 1e-9)) best = {rest, front, slender, score};
    }
  }

  double score_of(const Rest& rest, const glm::dvec3& front) const {
    const glm::dvec3 eye = eye_.y * rest.up + eye_.z * front;
    const SideAreas::Seen seen = areas_.from(eye);
    double flat = 0;  // flat cut area, because a plane's cut shows more than a peeler's or a baller's
    for (const CutSide& side : sides_)
      if (side.flat) flat += side.area * std::max(0.0, glm::dot(side.normal, eye));

    // Counts cut faces, and enough skin to show what was cut. Low and flat poses look natural; a fruit's top is away
    // from the eye, or to the right.
    const glm::dvec3 right = glm::cross(rest.up, front);
    const double away = -glm::dot(front, glm::dvec3(0, 1, 0)), aside = glm::dot(right, glm::dvec3(0, 1, 0));
    const double low = 1.25 - 0.5 * outline_.height(rest.up) / std::max(outline_.radius(), 1e-12);
    const double shown = seen.cut + flat + 0.6 * std::min(seen.skin, 0.5 * seen.cut) + 1e-3 * seen.skin;
    return shown * low * (rest.on_flat ? 1.15 : 1.0) * (1 + 0.15 * away + 0.05 * aside);
  }

  const Solid& solid_;
  glm::dvec3 eye_;
  PieceOutline outline_;
  SideAreas areas_;
  std::vector<CutSide> sides_;
  bool has_ground_;  ///< whether it has a flat bottom of its own
};

}  // namespace

glm::dvec3 eye_over_table() { return {0, reproducible::sin(eye_height), reproducible::cos(eye_height)}; }
glm::dvec3 eye_beside_table() { return {0, reproducible::sin(low_eye_height), reproducible::cos(low_eye_height)}; }

glm::dvec3 diagonal_on_table() { return {reproducible::sin(diagonal_angle), 0, -reproducible::cos(diagonal_angle)}; }

TablePose standing_pose(const Solid& solid, const glm::dvec3& eye) {
  if (solid.mesh.position.empty()) return {};
  const PoseChoice choice = Chooser(solid, eye).choose_standing();
  if (choice.score < 0) return table_pose(solid, eye);
  return {.rotation = standing_frame(choice.rest.up, choice.front), .as_grown = true};
}

TablePose table_pose(const Solid& solid, const glm::dvec3& eye) {
  if (solid.mesh.position.empty()) return {};
  const Chooser chooser(solid, eye);
  const PoseChoice choice = chooser.choose();
  if (choice.score < 0) return {};
  TablePose pose{.rotation = standing_frame(choice.rest.up, choice.front),
                 .slender = choice.slender,
                 .as_grown = choice.rest.as_grown,
                 .on_back = chooser.on_its_back(choice.rest),
                 .face = chooser.flat_face()};
  if (!pose.on_back) return pose;
  // The axis of leaning: the level line across the sight, or the diagonal for pieces along it.
  const glm::dvec3 axis = choice.slender ? diagonal_on_table() : glm::dvec3(1, 0, 0);
  pose.rotation = glm::normalize(turn_about(axis, lean_angle) * pose.rotation);
  return pose;
}

bool are_halves(const TablePose& one, const TablePose& other) {
  constexpr double opposite = -0.999, lengthwise = 0.3;
  if (one.as_grown || other.as_grown || !(one.on_back || other.on_back)) return false;
  return glm::dot(one.face, other.face) < opposite && std::abs(one.face.y) < lengthwise;
}

TablePose posed_alike(const TablePose& piece, const TablePose& model) {
  // Half a turn about the fruit's axis, as far as it lies in the face, takes one half to the other's place.
  const glm::dvec3 grows(0, 1, 0);
  const glm::dvec3 axis = glm::normalize(grows - glm::dot(grows, model.face) * model.face);
  TablePose pose = model;
  pose.rotation = glm::normalize(model.rotation * turn_about(axis, pi));
  pose.face = piece.face;
  return pose;
}

}  // namespace pomona
