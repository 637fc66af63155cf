#include "generator/diffusion/pmvc/cube_pmvc.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/pmvc/cube_directions.h"

namespace pomona {

namespace {

constexpr int face_count = 6;
constexpr int tile_texels = 8;  // side of the tiles whose farthest depth is kept, to reject what lies behind

/// Coordinates (u, v, depth) on face 2 * axis (looking along +axis) or 2 * axis + 1 (along -axis).
glm::dvec3 on_face(int face, const glm::dvec3& p) {
  const int axis = face / 2;
  return {p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? p[axis] : -p[axis]};
}

Box<double> on_face(int face, const Box<double>& box) {
  const glm::dvec3 a = on_face(face, box.low), b = on_face(face, box.high);
  return {glm::min(a, b), glm::max(a, b)};
}

/// A rectangle of texels of a face, both ends included.
struct Rectangle {
  int left = 0, right = -1, bottom = 0, top = -1;
  bool is_empty() const { return left > right || bottom > top; }
};

/// A range of u or v on a face.
struct CubeExtent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// A triangle in the coordinates of one face, relative to the point.
struct ProjectedTriangle {
  std::array<glm::dvec3, 3> edge;  ///< linear functions of D, >= 0 inside; edge[k] is opposite corner k
  glm::dvec3 inverse_depth{0};     ///< linear function of D
  std::uint32_t triangle = 0;
  SideOf side = SideOf::front;
  glm::dvec3 moment{0};  ///< sum of solid angle / |D| times D over the texels that it won
};

/// A face while it is drawn.
struct DrawnFace {
  std::vector<double> inverse_depth;        ///< inverse depth per texel; 0 = nothing yet
  std::vector<std::int32_t> winner;         ///< index into candidates per texel
  std::vector<double> tile_minimum;         ///< smallest inverse depth of each tile
  std::vector<std::uint8_t> tile_is_stale;  ///< whether the tile has been drawn into since
  std::vector<ProjectedTriangle> candidates;
};

/// The view from a point. It is reused from point to point for its buffers.
class CubeView {
 public:
  CubeView(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const CubeFace& directions)
      : surfaces_(surfaces), tree_(tree), directions_(directions), texels_(directions.texels) {}

  PmvcValue at(const glm::dvec3& point) {
    clear();
    visit(tree_.levels.size() - 1, 0, point, (1U << face_count) - 1);
    for (DrawnFace& face : faces_) gather(face);
    return sum();
  }

 private:
  void clear() {
    const auto area = static_cast<std::size_t>(texels_) * static_cast<std::size_t>(texels_);
    for (DrawnFace& face : faces_) {
      face.inverse_depth.assign(area, 0);
      face.winner.assign(area, -1);
      face.tile_minimum.assign(area / (tile_texels * tile_texels), 0);
      face.tile_is_stale.assign(area / (tile_texels * tile_texels), 0);
      face.candidates.clear();
    }
  }

  /// Draws the content of a box, if any of `faces` (a bit each) may see it; nearer boxes first.
  void visit(std::size_t level, std::size_t index, const glm::dvec3& point, unsigned faces) {
    faces = faces_that_see(tree_.levels[level][index], point, faces);
    if (faces == 0) return;
    if (level == 0) {
      const auto [first, end] = leaf(tree_, index);
      for (std::size_t i = first; i < end; ++i) draw(tree_.order[i], point, faces);
      return;
    }
    const NearestChildren inside = nearest_children(tree_, level, index, point);
    for (std::size_t i = 0; i < inside.count; ++i) visit(level - 1, inside.child[i].second, point, faces);
  }

  unsigned faces_that_see(const Box<double>& box, const glm::dvec3& point, unsigned faces) {
    unsigned seeing = 0;
    for (int f = 0; f < face_count; ++f) {
      if ((faces >> f & 1U) == 0) continue;
      const Box<double> local = on_face(f, Box<double>{box.low - point, box.high - point});
      const Rectangle rectangle = rectangle_of(local);
      if (rectangle.is_empty()) continue;
      const bool hidden = local.low.z > 0 && is_covered(faces_[f], rectangle, 1 / local.low.z);
      if (!hidden) seeing |= 1U << f;
    }
    return seeing;
  }

  /// The texels that a box may cover: all of the face if it reaches behind the point.
  Rectangle rectangle_of(const Box<double>& box) const {
    if (box.high.z <= 0) return {};
    const double depth = box.high.z;
    if (box.low.x > depth || box.high.x < -depth || box.low.y > depth || box.high.y < -depth) return {};
    if (box.low.z <= 0) return {0, texels_ - 1, 0, texels_ - 1};
    const auto min = [&](double x) { return x / (x < 0 ? box.low.z : box.high.z); };
    const auto max = [&](double x) { return x / (x < 0 ? box.high.z : box.low.z); };
    return texels_in({min(box.low.x), max(box.high.x)}, {min(box.low.y), max(box.high.y)});
  }

  /// The texels that a triangle may cover. An edge through the plane of the point reaches infinity.
  Rectangle rectangle_of(const std::array<glm::dvec3, 3>& corner) const {
    CubeExtent u, v;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 &p = corner[k], &q = corner[(k + 1) % 3];
      if (p.z > 0) {
        u.include(p.x / p.z);
        v.include(p.y / p.z);
      }
      if ((p.z > 0) == (q.z > 0)) continue;
      const glm::dvec3 crossing = p + (q - p) * (p.z / (p.z - q.z));
      if (crossing.x >= 0) u.include(2);
      if (crossing.x <= 0) u.include(-2);
      if (crossing.y >= 0) v.include(2);
      if (crossing.y <= 0) v.include(-2);
    }
    return texels_in(u, v);
  }

  /// The texels whose middles lie in the extents, with a margin for rounding.
  Rectangle texels_in(const CubeExtent& u, const CubeExtent& v) const {
    constexpr double slack = 1e-9;
    const auto place = [&](double x) { return (std::clamp(x, -2.0, 2.0) + 1) * 0.5 * texels_ - 0.5; };
    const auto first = [&](double x) { return std::max(0, static_cast<int>(std::ceil(place(x) - slack))); };
    const auto last = [&](double x) { return std::min(texels_ - 1, static_cast<int>(std::floor(place(x) + slack))); };
    if (u.low > u.high || v.low > v.high) return {};
    return {first(u.low), last(u.high), first(v.low), last(v.high)};
  }

  /// Whether everything drawn in a rectangle is nearer than `inverse_depth`: checks texels if there are few, else the
  /// tiles around them. Equal depths do not count as nearer, because the index decides between them.
  bool is_covered(DrawnFace& face, const Rectangle& rectangle, double inverse_depth) const {
    const int width = rectangle.right - rectangle.left + 1;
    if (width <= tile_texels && rectangle.top - rectangle.bottom < tile_texels) {
      for (int y = rectangle.bottom; y <= rectangle.top; ++y) {
        const double* row = &face.inverse_depth[static_cast<std::size_t>(y * texels_ + rectangle.left)];
        if (*std::min_element(row, row + width) <= inverse_depth) return false;
      }
      return true;
    }
    for (int y = rectangle.bottom / tile_texels; y <= rectangle.top / tile_texels; ++y) {
      for (int x = rectangle.left / tile_texels; x <= rectangle.right / tile_texels; ++x) {
        if (tile_minimum(face, x, y) <= inverse_depth) return false;
      }
    }
    return true;
  }

  double tile_minimum(DrawnFace& face, int tile_x, int tile_y) const {
    const auto tile = static_cast<std::size_t>(tile_y * (texels_ / tile_texels) + tile_x);
    if (face.tile_is_stale[tile] == 0) return face.tile_minimum[tile];
    double min = std::numeric_limits<double>::infinity();
    for (int y = tile_y * tile_texels; y < (tile_y + 1) * tile_texels; ++y) {
      const double* row = &face.inverse_depth[static_cast<std::size_t>(y * texels_ + tile_x * tile_texels)];
      min = std::min(min, *std::min_element(row, row + tile_texels));
    }
    face.tile_is_stale[tile] = 0;
    return face.tile_minimum[tile] = min;
  }

  /// Draws a triangle on each of `faces`, unless it is seen edge-on.
  void draw(std::uint32_t triangle, const glm::dvec3& point, unsigned faces) {
    const auto [a, b, c] = corners(surfaces_, triangle);
    const std::array<glm::dvec3, 3> corner{a - point, b - point, c - point};
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double volume = glm::dot(normal, corner[0]);
    if (volume == 0) return;

    for (int f = 0; f < face_count; ++f) {
      if ((faces >> f & 1U) == 0) continue;
      const std::array<glm::dvec3, 3> local{on_face(f, corner[0]), on_face(f, corner[1]), on_face(f, corner[2])};
      const Rectangle rectangle = rectangle_of(local);
      if (rectangle.is_empty()) continue;
      const double nearest = std::min({local[0].z, local[1].z, local[2].z});
      if (nearest > 0 && is_covered(faces_[f], rectangle, 1 / nearest)) continue;

      // Faces along -axis are mirror images: there a positive volume turns negative.
      const bool turned = (volume < 0) != (f % 2 == 1);
      ProjectedTriangle candidate;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = glm::cross(local[(k + 1) % 3], local[(k + 2) % 3]);
        candidate.edge[k] = turned ? -edge : edge;
      }
      candidate.inverse_depth = on_face(f, normal) / volume;
      candidate.triangle = triangle;
      candidate.side = volume < 0 ? SideOf::front : SideOf::back;
      faces_[f].candidates.push_back(candidate);
      fill(faces_[f], rectangle);
    }
  }

  /// Gives the last candidate the texels where it is the nearest.
  void fill(DrawnFace& face, const Rectangle& rectangle) const {
    // Sums that all texels of a row share are computed once for the row.
    const ProjectedTriangle& candidate = face.candidates.back();
    const auto index = static_cast<std::int32_t>(face.candidates.size()) - 1;
    bool won = false;
    for (int y = rectangle.bottom; y <= rectangle.top; ++y) {
      const double v = directions_.middle[static_cast<std::size_t>(y)];
      const auto along_row = [&](const glm::dvec3& f) { return f.y * v + f.z; };
      const double row_0 = along_row(candidate.edge[0]), row_1 = along_row(candidate.edge[1]);
      const double row_2 = along_row(candidate.edge[2]), row_depth = along_row(candidate.inverse_depth);

      // A texel is the candidate's if its direction passes inside all three edges, and meets nothing nearer.
      for (int x = rectangle.left; x <= rectangle.right; ++x) {
        const double u = directions_.middle[static_cast<std::size_t>(x)];
        if (candidate.edge[0].x * u + row_0 < 0 || candidate.edge[1].x * u + row_1 < 0 ||
            candidate.edge[2].x * u + row_2 < 0) {
          continue;
        }
        const double nearness = candidate.inverse_depth.x * u + row_depth;
        const auto texel = static_cast<std::size_t>(y * texels_ + x);
        if (!is_nearer(face, texel, nearness, candidate.triangle)) continue;
        face.inverse_depth[texel] = nearness;
        face.winner[texel] = index;
        won = true;
      }
    }

    // The farthest texel of these tiles may have changed.
    if (won) mark_stale(face, rectangle);
  }

  static bool is_nearer(const DrawnFace& face, std::size_t texel, double nearness, std::uint32_t triangle) {
    const double best = face.inverse_depth[texel];
    if (nearness != best) return nearness > best;
    const std::int32_t winner = face.winner[texel];
    return winner >= 0 && triangle < face.candidates[static_cast<std::size_t>(winner)].triangle;
  }

  void mark_stale(DrawnFace& face, const Rectangle& rectangle) const {
    for (int y = rectangle.bottom / tile_texels; y <= rectangle.top / tile_texels; ++y) {
      for (int x = rectangle.left / tile_texels; x <= rectangle.right / tile_texels; ++x) {
        face.tile_is_stale[static_cast<std::size_t>(y * (texels_ / tile_texels) + x)] = 1;
      }
    }
  }

  /// Sums the directions of the texels that each candidate has won. Distance is depth times |D|.
  void gather(DrawnFace& face) const {
    std::size_t texel = 0;
    for (const double v : directions_.middle) {
      for (const double u : directions_.middle) {
        const std::int32_t winner = face.winner[texel];
        const double weight = directions_.solid_angle[texel] / directions_.length[texel];
        if (winner >= 0) {
          face.candidates[static_cast<std::size_t>(winner)].moment += weight * glm::dvec3(u, v, 1);
        }
        ++texel;
      }
    }
  }

  PmvcValue sum() {
    PmvcValue value;
    part_.assign(surfaces_.part_names.size(), 0);
    for (const DrawnFace& face : faces_) {
      for (const ProjectedTriangle& candidate : face.candidates) {
        if (candidate.moment.z == 0) continue;
        const double weight = glm::dot(candidate.inverse_depth, candidate.moment);
        value.color += weight * mean_color(candidate);
        value.weight += weight;
        const auto& parts = candidate.side == SideOf::front ? surfaces_.front_part : surfaces_.back_part;
        part_[static_cast<std::size_t>(parts[candidate.triangle])] += weight;
      }
    }
    if (value.weight > 0) value.color /= value.weight;
    value.part = static_cast<std::int32_t>(std::max_element(part_.begin(), part_.end()) - part_.begin());
    return value;
  }

  /// The colour of the visible part of a triangle, weighted by 1 / d.
  glm::dvec3 mean_color(const ProjectedTriangle& candidate) const {
    const glm::uvec3& t = surfaces_.triangle[candidate.triangle];
    const auto& color = candidate.side == SideOf::front ? surfaces_.front_color : surfaces_.back_color;
    glm::dvec3 sum_of_colors{0};
    double sum_of_shares = 0;
    for (int k = 0; k < 3; ++k) {
      const double share = glm::dot(candidate.edge[static_cast<std::size_t>(k)], candidate.moment);
      sum_of_colors += share * glm::dvec3(color[t[k]]);
      sum_of_shares += share;
    }
    return sum_of_colors / sum_of_shares;
  }

  const DiffusionSurfaces& surfaces_;
  const SurfaceTree& tree_;
  const CubeFace& directions_;
  int texels_;
  std::array<DrawnFace, face_count> faces_;
  std::vector<double> part_;
};

}  // namespace

std::vector<PmvcValue> cube_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, int texels, Threads threads) {
  const CubeFace directions = make_cube_face(texels);
  std::vector<PmvcValue> values(points.size());
  constexpr std::size_t at_once = 16;  // number of points that share one view's buffers
  parallel_for((points.size() + at_once - 1) / at_once, threads, [&](std::size_t block) {
    CubeView view(surfaces, tree, directions);
    const std::size_t end = std::min(points.size(), (block + 1) * at_once);
    for (std::size_t i = block * at_once; i < end; ++i) values[i] = view.at(glm::dvec3(points[i]));
  });
  return values;
}

}  // namespace pomona
