#include "generator/scene/lay_out.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_state.h"
#include "generator/scene/hanging_peel.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/table_pose.h"

namespace pomona {

namespace {

/// The space between pieces: shares of the mean of their sizes, and of a piece's height, because it hides what lies
/// behind it: half of the height from eye_over_table(), most of it from eye_beside_table().
constexpr double row_gap = 0.14, hidden = 0.45, hidden_from_beside = 1.9;

Box<double> turned_bounds(const Solid& solid, const glm::dquat& rotation) {
  if (solid.mesh.position.empty()) return {glm::dvec3(0), glm::dvec3(0)};
  Box<double> bounds;
  for (const glm::vec3& p : solid.mesh.position) bounds.add(rotation * glm::dvec3(p));
  return bounds;
}

/// The pieces that are laid out.
struct Tray {
  std::vector<Box<double>> bounds;  ///< boxes of pieces, turned back by `turn`
  std::vector<glm::dvec2> room;     ///< size of a piece in its row, and towards the eye
  glm::dquat turn{1, 0, 0, 0};      ///< about +Y: it turns -z to the diagonal
  bool diagonal = false;
};

/// Pieces along the diagonal are still in level rows, like the strokes of ////.
void measure(Tray& tray, double hidden_share) {
  double mean = 0;
  for (const Box<double>& box : tray.bounds) mean += box.size().x + box.size().z;
  mean /= 2 * static_cast<double>(tray.bounds.size());
  const glm::dvec3 along = tray.diagonal ? diagonal_on_table() : glm::dvec3(0, 0, -1);
  for (const Box<double>& box : tray.bounds) {
    const glm::dvec3 size = box.size();
    const double space = row_gap * mean, behind = hidden_share * size.y;
    const double wide = size.x + space + (tray.diagonal ? behind : 0);
    tray.room.emplace_back(wide / -along.z, size.x * along.x - size.z * along.z + space + behind);
  }
}

/// Larger pieces first, so that small ones share a row.
std::vector<std::size_t> by_size(const std::vector<glm::dvec2>& room) {
  std::vector<std::size_t> order(room.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rough_size = [&](std::size_t i) { return std::lround(2 * reproducible::log(room[i].x + room[i].y)); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rough_size(a) > rough_size(b); });
  return order;
}

/// Whether a piece is less than a third as large as the one before, as balls beside halves.
bool is_far_smaller(const glm::dvec2& room, const glm::dvec2& before) {
  return 3 * (room.x + room.y) < before.x + before.y;
}

/// Conditions for the end of a row.
struct RowEnd {
  double width = 0;    ///< a row ends if a piece would reach beyond this width,
  bool apart = false;  ///< or if one is far smaller than the one before
};

/// Fills rows from the left, the first row farthest from the eye, and then centres each row. Returns the displacements
/// of the turned pieces.
std::vector<glm::dvec3> filled_rows(const Tray& tray, const std::vector<std::size_t>& order, const RowEnd& row_end) {
  std::vector<glm::dvec3> place(order.size());
  double z = 0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const auto belongs = [&](std::size_t k, double filled) {
      const glm::dvec2 &room = tray.room[order[k]], &before = tray.room[order[k - 1]];
      return filled + room.x <= row_end.width && !(row_end.apart && is_far_smaller(room, before));
    };
    double x = 0, depth = 0;
    for (; end < order.size() && (end == begin || belongs(end, x)); ++end) {
      const glm::dvec2& room = tray.room[order[end]];
      place[order[end]].x = x + 0.5 * room.x;
      x += room.x;
      depth = std::max(depth, room.y);
    }
    for (std::size_t k = begin; k < end; ++k) {
      // The near edges of a row's pieces are in line.
      const std::size_t i = order[k];
      place[i].x -= 0.5 * x;
      place[i].z = z + depth - (tray.diagonal ? 0.5 * depth : 0.5 * tray.bounds[i].size().z);
    }
    z += depth;
  }
  for (std::size_t i = 0; i < place.size(); ++i) {
    const glm::dvec3 middle = tray.turn * tray.bounds[i].center();
    place[i] -= glm::dvec3(middle.x, tray.bounds[i].low.y, middle.z);
  }
  return place;
}

/// The largest scale (share of the picture's height per metre) at which all pieces and roughly their shadows fit.
double drawn_scale(const Tray& tray, const std::vector<glm::dvec3>& place, const glm::dvec3& back, double aspect) {
  const glm::dvec3 right(1, 0, 0), up = glm::cross(back, right);
  // The light comes from over the left shoulder, at 45 degrees.
  const glm::dvec3 shadow(0.65, 0, -0.5);
  Box<double> seen;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const Box<double>& box = tray.bounds[i];
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 p = tray.turn * glm::mix(box.low, box.high, share) + place[i];
      for (const glm::dvec3& q : {p, p + p.y * shadow - glm::dvec3(0, p.y, 0)})
        seen.add({glm::dot(q, right), glm::dot(q, up), 0});
    }
  }
  return std::min(aspect / seen.size().x, 1 / seen.size().y);
}

/// Widths to try for the longest row: for 1, 2, ... rows, or for a first row of exactly 1, 2, ... pieces.
std::vector<double> row_widths(const Tray& tray, const std::vector<std::size_t>& order) {
  double total = 0, widest = 0;
  for (const glm::dvec2& room : tray.room) {
    total += room.x;
    widest = std::max(widest, room.x);
  }
  const std::size_t max = std::min<std::size_t>(order.size(), 40);
  std::vector<double> widths;
  double filled = 0;
  for (std::size_t k = 0; k < max; ++k) {
    filled += tray.room[order[k]].x;
    for (const double width : {filled, total / static_cast<double>(k + 1) * 1.06})
      widths.push_back(std::max(widest, width * 1.0001));
  }
  std::sort(widths.rbegin(), widths.rend());
  return widths;
}

struct Places {
  std::vector<glm::dvec3> of_piece;
  double scale = 0;  ///< drawn_scale()
};

/// From beside the table, one of two pieces in two rows would hide the other, and be drawn at another scale.
bool is_standing_pair(const Tray& tray, const glm::dvec3& back) {
  return tray.bounds.size() == 2 && back == eye_beside_table();
}

Places best_rows(const Tray& tray, const std::vector<std::size_t>& order, bool apart, const glm::dvec3& back,
                 double aspect) {
  Places best;
  std::vector<double> widths = row_widths(tray, order);
  if (is_standing_pair(tray, back)) widths = {widths.front()};
  // Two halves lie side by side, unless they are much larger one behind the other.
  const double gain = order.size() <= 4 ? 1.12 : 1.005;
  for (const double width : widths) {
    std::vector<glm::dvec3> place = filled_rows(tray, order, {width, apart});
    const double scale = drawn_scale(tray, place, back, aspect);
    if (scale > best.scale * gain) best = {std::move(place), scale};
  }
  return best;
}

/// Far smaller pieces have rows of their own, unless all would be drawn smaller.
std::vector<glm::dvec3> best_places(const Tray& tray, const glm::dvec3& back, double aspect) {
  const std::vector<std::size_t> order = by_size(tray.room);
  Places mixed = best_rows(tray, order, false, back, aspect);
  const auto parts = std::adjacent_find(order.begin(), order.end(), [&](std::size_t before, std::size_t i) {
    return is_far_smaller(tray.room[i], tray.room[before]);
  });
  if (parts == order.end()) return std::move(mixed.of_piece);
  Places apart = best_rows(tray, order, true, back, aspect);
  return apart.scale >= 0.98 * mixed.scale ? std::move(apart.of_piece) : std::move(mixed.of_piece);
}

/// Other pieces may wind about the axis, too: leaves of a cabbage do.
bool may_be_peel(const Solid& solid) {
  const std::vector<std::string>& knives = solid.origin.knives;
  return knives.empty() || std::any_of(knives.begin(), knives.end(), is_peeler);
}

/// Hangs up strips of peel.
/// \returns whether there are any.
bool hang_peels(Scene& table) {
  bool any = false;
  for (Solid& solid : table.solids) {
    std::optional<Solid> hung = may_be_peel(solid) ? hanging_peel(solid) : std::nullopt;
    if (!hung) continue;
    solid = std::move(*hung);
    any = true;
  }
  return any;
}

/// One for each piece.
struct TablePoses {
  std::vector<TablePose> of_piece;
  bool halves = false;  ///< two halves: they lie alike, long ones each along the diagonal
};
TablePoses table_poses(const Scene& table, const glm::dvec3& eye, bool upright) {
  TablePoses all;
  std::vector<TablePose>& poses = all.of_piece;
  for (const Instance& instance : table.instances) {
    const Solid& solid = table.solids[static_cast<std::size_t>(instance.solid)];
    poses.push_back(upright ? standing_pose(solid, eye) : table_pose(solid, eye));
  }
  all.halves = poses.size() == 2 && are_halves(poses[0], poses[1]);
  const auto lies_along_diagonal = [](const TablePose& pose) { return pose.slender && pose.on_back; };
  if (!all.halves || std::all_of(poses.begin(), poses.end(), lies_along_diagonal)) return all;
  const std::size_t model = poses[0].on_back ? 0 : 1, other = 1 - model;
  poses[other] = posed_alike(poses[other], poses[model]);
  return all;
}

/// Turns all pieces.
/// \param upright pieces without flat cuts stand as they grew.
/// \returns how many are slender, the share of the volume that stands as it grew, and whether they are two halves.
struct Turned {
  std::size_t slender = 0;
  double as_grown = 0;
  bool halves = false;
};
Turned turn_all(Scene& table, const glm::dvec3& eye, bool upright) {
  Turned turned;
  double volume = 0, standing_volume = 0;
  const TablePoses poses = table_poses(table, eye, upright);
  turned.halves = poses.halves;
  for (std::size_t i = 0; i < poses.of_piece.size(); ++i) {
    const TablePose& pose = poses.of_piece[i];
    const Solid& solid = table.solids[static_cast<std::size_t>(table.instances[i].solid)];
    table.instances[i].pose.rotation = pose.rotation;
    turned.slender += pose.slender ? 1 : 0;
    volume += solid.volume;
    if (pose.as_grown && !pose.slender) standing_volume += solid.volume;
  }
  turned.as_grown = volume > 0 ? standing_volume / volume : 0;
  return turned;
}

/// Turns pieces along the diagonal to -z.
Tray tray_of(const Scene& table, bool diagonal, double hidden_share) {
  Tray tray;
  tray.diagonal = diagonal;
  const glm::dvec3 along = diagonal_on_table();
  if (diagonal) tray.turn = turn_about({0, 1, 0}, reproducible::atan2(-along.x, -along.z));
  for (const Instance& instance : table.instances)
    tray.bounds.push_back(turned_bounds(table.solids[static_cast<std::size_t>(instance.solid)],
                                        glm::conjugate(tray.turn) * instance.pose.rotation));
  measure(tray, hidden_share);
  return tray;
}

}  // namespace

Scene without_crumbs(Scene pieces) {
  constexpr double of_all = 1.0 / 2500, of_mean = 1.0 / 20;
  const auto solid = [&](const Instance& piece) -> const Solid& {
    return pieces.solids[static_cast<std::size_t>(piece.solid)];
  };
  double all = 0;
  for (const Instance& piece : pieces.instances) all += solid(piece).volume;
  const double mean = all / static_cast<double>(std::max<std::size_t>(1, pieces.instances.size()));
  const double crumb = std::min(of_all * all, of_mean * mean);
  std::erase_if(pieces.instances,
                [&](const Instance& piece) { return solid(piece).closed && solid(piece).volume < crumb; });
  return pieces;
}

Scene laid_out(const Scene& scene, double aspect, Peels peels) {
  Scene table = scene;
  table.ground = true;
  glm::dvec3 eye = eye_over_table();
  if (!table.instances.empty()) {
    const bool hangs = peels == Peels::hang && hang_peels(table);
    Turned turned = turn_all(table, eye, hangs);
    const bool stands = turned.as_grown > 0.5;
    if (stands) {
      eye = eye_beside_table();
      turned = turn_all(table, eye, hangs);
    }
    const Tray tray = tray_of(table, 2 * turned.slender > table.instances.size(), stands ? hidden_from_beside : hidden);
    const std::vector<glm::dvec3> place = best_places(tray, eye, aspect);
    for (std::size_t i = 0; i < place.size(); ++i) table.instances[i].pose.translation = place[i];
    if (turned.halves && tray.diagonal) table.view.vertical_field = narrow_field;
  }
  table.view = fitted_view(table, eye, aspect);
  return table;
}

}  // namespace pomona
