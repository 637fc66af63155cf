#include "render/texture/face_colors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

using Cell = FaceColors::Cell;

constexpr float min_jump = 2e-3f;  // smallest jump of a linear channel between two sides of an edge

/// The largest difference of a channel as pictures show it, of 255.
double encoded_difference(const Color& a, const Color& b) {
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = srgb_from_linear(static_cast<double>(a[k])), y = srgb_from_linear(static_cast<double>(b[k]));
    largest = std::max(largest, std::abs(x - y));
  }
  return 255 * largest;
}

/// Colours at points of space, each computed once.
class AskedPoints {
 public:
  /// The index of a point, which is added if it is new.
  std::uint32_t number(const glm::vec3& point) {
    const auto [entry, is_new] = known_.try_emplace(point, static_cast<std::uint32_t>(point_.size()));
    if (is_new) point_.push_back(point);
    return entry->second;
  }

  /// Computes the colours of all points that have none.
  void ask(const ColorField& field) {
    if (color_.size() == point_.size()) return;
    const DiffusedColors found = field.at(std::span(point_).subspan(color_.size()));
    color_.insert(color_.end(), found.color.begin(), found.color.end());
  }

  const Color& color(std::uint32_t number) const { return color_[number]; }
  std::size_t size() const { return point_.size(); }

 private:
  struct Hash {
    std::size_t operator()(const glm::vec3& p) const {
      std::uint64_t hash = 0;
      for (int k = 0; k < 3; ++k) hash = (hash ^ std::bit_cast<std::uint32_t>(p[k] + 0.0f)) * 0x9e3779b97f4a7c15u;
      return hash ^ (hash >> 29);
    }
  };
  std::unordered_map<glm::vec3, std::uint32_t, Hash> known_;
  std::vector<glm::vec3> point_;
  std::vector<Color> color_;
};

/// Subdivides one solid's cut faces.
class Subdivision {
 public:
  Subdivision(const FaceColorTask& task, const FaceColorOptions& options, FaceColors& result)
      : solid_(*task.solid), options_(options), texel_(task.texel), result_(result) {
    result_.root.assign(solid_.mesh.triangle.size(), -1);
    node_of_.assign(solid_.mesh.position.size(), none);
    for (std::uint32_t t = 0; t < solid_.mesh.triangle.size(); ++t) {
      if (solid_.mesh.cut_face[t] < 0) continue;
      result_.root[t] = static_cast<std::int32_t>(result_.cells.size());
      open_.push_back(static_cast<std::uint32_t>(result_.cells.size()));
      face_.push_back(solid_.mesh.cut_face[t]);
      const glm::uvec3& v = solid_.mesh.triangle[t];
      result_.cells.push_back({.corner = {corner_node(v.x), corner_node(v.y), corner_node(v.z)}});
    }
    corners_ = static_cast<std::uint32_t>(position_.size());
    mark_surfaces();
  }

  bool is_done() const { return open_.empty(); }

  /// Makes the middles of the open cells, and requests the colours that they need.
  void open(AskedPoints& asked) {
    for (const std::uint32_t c : open_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<std::uint32_t, 3> corner = result_.cells[c].corner;
        const std::uint32_t a = corner[k], b = corner[(k + 1) % 3];
        Edge& edge = lay(a, b, 0.5f * (result_.color[a] + result_.color[b]), false);
        result_.cells[c].middle[k] = edge.middle;
        if (edge.is_asked || !wants_middle(a, b, edge)) continue;
        edge.is_asked = true;
        pending_.push_back({&edge, asked.number(point_on(edge, corner[(k + 2) % 3]))});
      }
    }
  }

  /// Takes the colours and subdivides the cells that need it; their children are the open cells then.
  void close(const AskedPoints& asked, bool may_part) {
    for (const auto& [edge, number] : pending_) {
      Color& color = result_.color[edge->middle];
      edge->miss = encoded_difference(color, asked.color(number));
      color = asked.color(number);
    }
    pending_.clear();
    std::vector<std::uint32_t> parts;
    for (const std::uint32_t c : open_) {
      if (!may_part || !must_be_parted(c)) continue;
      part(c);
      for (std::uint32_t i = 0; i < 4; ++i)
        parts.push_back(static_cast<std::uint32_t>(result_.cells[c].first_child) + i);
    }
    open_ = std::move(parts);
  }

 private:
  struct Edge {
    std::uint32_t middle = 0;
    bool in_surface = false;  // colours may jump across the edge, or it is a rim: the colour is that of the cell's side
    bool is_asked = false;
    double miss = 0;  // difference of the middle's colour from the predicted one, of 255
  };
  struct Pending {
    Edge* edge = nullptr;
    std::uint32_t number = 0;
  };
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t add_node(const glm::vec3& position, const Color& color, bool at_end) {
    position_.push_back(position);
    at_end_.push_back(at_end ? 1 : 0);
    result_.color.push_back(color);
    return static_cast<std::uint32_t>(position_.size() - 1);
  }

  std::uint32_t corner_node(std::uint32_t vertex) {
    std::uint32_t& node = node_of_[vertex];
    if (node == none) node = add_node(solid_.mesh.position[vertex], solid_.mesh.color[vertex], false);
    return node;
  }

  /// Finds the edges in surfaces: the section's vertices are doubled there. Where a knife's faces meet within the flesh
  /// they are doubled, too, and have the same colours. Where not exactly two such edges meet, a surface ends or
  /// branches, and the vertex has the colour of no side.
  void mark_surfaces() {
    std::vector<glm::uvec3> triangles;
    for (const Cell& cell : result_.cells) triangles.emplace_back(cell.corner[0], cell.corner[1], cell.corner[2]);
    const std::vector<std::uint32_t> place_of = weld(position_);
    std::vector<int> edges_at(position_.size(), 0);
    for_each_edge(sorted_half_edges(welded_triangles(place_of, triangles)), [&](std::span<const HalfEdge> edge) {
      bool any = false;
      for (const HalfEdge& h : edge) {
        const glm::uvec2 ends = ends_in(triangles, h);
        const bool goes_on = std::any_of(edge.begin(), edge.end(), [&](const HalfEdge& other) {
          return other.triangle != h.triangle &&
                 is_same(ends, face_[h.triangle], ends_in(triangles, other), face_[other.triangle]);
        });
        if (goes_on) continue;
        any = true;
        lay(ends.x, ends.y, 0.5f * (result_.color[ends.x] + result_.color[ends.y]), true);
      }
      if (any) ++edges_at[edge.front().low], ++edges_at[edge.front().high];
    });
    for (std::uint32_t node = 0; node < corners_; ++node) {
      const int count = edges_at[place_of[node]];
      at_end_[node] = count != 0 && count != 2 ? 1 : 0;
    }
  }

  /// Whether an edge with these ends, of two triangles, is within the flesh.
  bool is_same(const glm::uvec2& a, std::int32_t face_a, const glm::uvec2& b, std::int32_t face_b) const {
    if (a == b) return true;
    for (int k = 0; k < 2; ++k) {
      const Color d = glm::abs(result_.color[a[k]] - result_.color[b[k]]);
      if (face_a == face_b || std::max({d.r, d.g, d.b}) > min_jump) return false;
    }
    return true;
  }

  double texels_between(std::uint32_t a, std::uint32_t b) const {
    return static_cast<double>(glm::distance(position_[a], position_[b])) / texel_;
  }

  /// The edge, new or known.
  /// \param predicted the predicted colour of its middle, if it is new
  Edge& lay(std::uint32_t a, std::uint32_t b, const Color& predicted, bool in_surface) {
    const auto [edge, is_new] = edge_.try_emplace({a, b});
    if (!is_new) return edge;
    edge.in_surface = in_surface;
    const Color mean = 0.5f * (result_.color[a] + result_.color[b]);
    edge.middle = add_node(0.5f * (position_[a] + position_[b]), mean, false);
    if (wants_middle(a, b, edge)) result_.color[edge.middle] = predicted;
    return edge;
  }

  bool wants_middle(std::uint32_t a, std::uint32_t b, const Edge& edge) const {
    const double length = texels_between(a, b);
    if (length <= options_.shortest) return false;
    if (edge.in_surface) return at_end_[a] != 0 || at_end_[b] != 0;
    if (length > options_.longest || (a < corners_ && b < corners_)) return true;
    return encoded_difference(result_.color[a], result_.color[b]) > options_.even;
  }

  /// The place at which an edge's middle is sampled: in a surface, a little towards `corner`.
  glm::vec3 point_on(const Edge& edge, std::uint32_t corner) const {
    constexpr double aside = 0.02;  // texels
    const glm::vec3& middle = position_[edge.middle];
    if (!edge.in_surface) return middle;
    const glm::dvec3 way(position_[corner] - middle);
    const double length = glm::length(way);
    if (!(length > 0)) return middle;
    return glm::vec3(glm::dvec3(middle) + way * std::min(0.1, aside * texel_ / length));
  }

  /// Divides where a middle was not predicted well, and where all edges of a triangle lie in surfaces, because nothing
  /// is known of its inside.
  bool must_be_parted(std::uint32_t c) {
    const Cell& cell = result_.cells[c];
    int in_surface = 0;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = cell.corner[k], b = cell.corner[(k + 1) % 3];
      const Edge& edge = lay(a, b, Color(0), false);
      if (edge.is_asked && edge.miss > options_.tolerance) return true;
      in_surface += edge.in_surface ? 1 : 0;
      longest = std::max(longest, texels_between(a, b));
    }
    return in_surface == 3 && longest > 2 * options_.shortest;
  }

  /// Divides into four; the middles of new edges are predicted by the parabola.
  void part(std::uint32_t c) {
    const Cell cell = result_.cells[c];
    const auto& p = cell.corner;
    const auto& m = cell.middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, n = (k + 2) % 3;
      const Color a = result_.color[p[k]], b = result_.color[p[l]], far = result_.color[p[n]];
      const Color ab = result_.color[m[k]], b_far = result_.color[m[l]], a_far = result_.color[m[n]];
      const Color beside_a = 0.375f * a + 0.75f * ab - 0.125f * b, beside_b = 0.375f * b + 0.75f * ab - 0.125f * a;
      const Color inside = 0.5f * (ab + a_far) + 0.25f * b_far - 0.125f * (b + far);
      const bool in_surface = lay(p[k], p[l], Color(0), false).in_surface;
      lay(p[k], m[k], beside_a, in_surface);
      lay(m[k], p[l], beside_b, in_surface);
      lay(m[k], m[n], inside, false);
    }
    result_.cells[c].first_child = static_cast<std::int32_t>(result_.cells.size());
    result_.cells.push_back({.corner = {p[0], m[0], m[2]}});
    result_.cells.push_back({.corner = {m[0], p[1], m[1]}});
    result_.cells.push_back({.corner = {m[2], m[1], p[2]}});
    result_.cells.push_back({.corner = {m[1], m[2], m[0]}});
  }

  const Solid& solid_;
  const FaceColorOptions& options_;
  double texel_;
  FaceColors& result_;
  std::vector<std::int32_t> face_;      // per cell that is a triangle of the solid
  std::vector<std::uint32_t> node_of_;  // per vertex of the solid
  std::uint32_t corners_ = 0;           // nodes that are vertices of the solid
  std::vector<glm::vec3> position_;     // per node, like the colours of the result
  std::vector<std::uint8_t> at_end_;    // per node: where surfaces end or branch
  EdgeMap<Edge> edge_;
  std::vector<Pending> pending_;
  std::vector<std::uint32_t> open_;
};

}  // namespace

Color FaceColors::at(std::uint32_t triangle, const glm::dvec3& weight) const {
  // Goes down to the smallest cell that contains the place.
  const Cell* cell = &cells[static_cast<std::size_t>(root[triangle])];
  glm::dvec3 w = weight;
  while (cell->first_child >= 0) {
    int child = 3;
    for (int k = 0; k < 3; ++k) {
      if (w[k] >= 0.5) child = k;
    }
    if (child == 3) {
      w = 1.0 - 2.0 * w;
    } else {
      w *= 2.0;
      w[child] -= 1;
    }
    cell = &cells[static_cast<std::size_t>(cell->first_child + child)];
  }

  // The parabola there, within the range of its colours.
  Color sum(0), low(2), high(-1);
  for (int k = 0; k < 3; ++k) {
    const Color &corner = color[cell->corner[static_cast<std::size_t>(k)]],
                &middle = color[cell->middle[static_cast<std::size_t>(k)]];
    sum += static_cast<float>(w[k] * (2 * w[k] - 1)) * corner;
    sum += static_cast<float>(4 * w[k] * w[(k + 1) % 3]) * middle;
    low = glm::min(low, glm::min(corner, middle));
    high = glm::max(high, glm::max(corner, middle));
  }
  return glm::clamp(sum, low, high);
}

DiffusedFaces diffused_faces(std::span<const FaceColorTask> tasks, const ColorField& field,
                             const FaceColorOptions& options) {
  DiffusedFaces result;
  result.of_solid.resize(tasks.size());
  std::vector<Subdivision> subdivisions;
  subdivisions.reserve(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) subdivisions.emplace_back(tasks[i], options, result.of_solid[i]);

  // Works in rounds, so that the field gets many points at a time.
  AskedPoints asked;
  for (int round = 0; round < options.max_rounds; ++round) {
    for (Subdivision& subdivision : subdivisions) subdivision.open(asked);
    asked.ask(field);
    for (Subdivision& subdivision : subdivisions) subdivision.close(asked, round + 1 < options.max_rounds);
    if (std::all_of(subdivisions.begin(), subdivisions.end(), [](const Subdivision& p) { return p.is_done(); })) break;
  }
  result.points = asked.size();
  return result;
}

}  // namespace pomona
