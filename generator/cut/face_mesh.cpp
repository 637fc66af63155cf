#include "generator/cut/face_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/cut_lines.h"
#include "generator/cut/regions.h"
#include "generator/cut/size_field.h"

namespace pomona {

std::span<const EdgeUse> FaceMesh::uses(std::uint32_t p, std::uint32_t q) const {
  const auto less = [](const EdgeUse& a, const EdgeUse& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };
  const EdgeUse key{std::min(p, q), std::max(p, q), 0, false};
  const auto range = std::equal_range(edges.begin(), edges.end(), key, less);
  return {range.first, range.second};
}

double FaceMesh::distance(std::uint32_t p, std::uint32_t q) const {
  return solid ? glm::distance(solid->place[p], solid->place[q]) : glm::distance(mesh.point[p], mesh.point[q]);
}

std::size_t FaceMesh::facets() const { return solid ? solid->frame.size() : sheet.facets(); }

/// No triangle reaches over a crease.
std::size_t FaceMesh::facet_of(std::size_t triangle) const {
  if (solid) return solid->facet[triangle];
  double u = 0;
  for (int i = 0; i < 3; ++i) u += mesh.point[mesh.triangle[triangle][i]].x / 3;
  return static_cast<std::size_t>(sheet.facet_at(u));
}

const CutFace& FaceMesh::frame(std::size_t facet) const {
  return solid ? solid->frame[facet] : sheet.frame(static_cast<int>(facet));
}

std::array<glm::vec3, 3> FaceMesh::normals(std::size_t triangle) const {
  if (solid) return solid->normal[triangle];
  std::array<glm::vec3, 3> all{};
  for (std::size_t i = 0; i < 3; ++i) {
    all[i] = sheet.normal_at(facet_of(triangle), mesh.point[mesh.triangle[triangle][static_cast<int>(i)]]);
  }
  return all;
}

namespace {

/// Two points of the split mesh at one place.
using Twins = std::pair<std::uint32_t, std::uint32_t>;

/// Points on lines that not all planes there know of.
using Unshared = std::map<const CutLine*, std::vector<std::uint32_t>>;

/// An edge of the split mesh as constraints of the triangulation: one, or several where it runs along a line in which
/// planes meet.
struct MeshEdge {
  std::uint32_t low = 0, high = 0;  // points
  std::vector<std::uint32_t> constraint;
};

/// Next to surfaces of one colour edges may be this many times as long as the surfaces' own.
constexpr double plain_growth = 3;

/// What the size field is to know of a segment but for its place; `size` counts in edges' lengths. Colours that change
/// by a quarter of `contrast` or more from edge to edge want edges as long as their own next to them, others longer
/// ones.
SizeSource source_of(const Segment& s, const SplitMesh& mesh, double contrast) {
  const Color &front_from = mesh.front_color[s.from_vertex], &front_to = mesh.front_color[s.to_vertex],
              &back_from = mesh.back_color[s.from_vertex], &back_to = mesh.back_color[s.to_vertex];
  const Color change = glm::max(glm::abs(front_to - front_from), glm::abs(back_to - back_from));
  const double most = static_cast<double>(std::max({change.x, change.y, change.z}));
  SizeSource source;
  source.size = std::clamp(std::sqrt(0.25 * contrast / std::max(most, 1e-6)), 1.0, plain_growth);
  source.left = 0.5f * (front_from + front_to);
  source.right = 0.5f * (back_from + back_to);
  return source;
}

/// Triangulates one plane step by step.
class FaceBuilder {
 public:
  FaceBuilder(const SplitMesh& mesh, const CutPlanes& planes, int plane, std::vector<Segment> segments,
              const std::vector<CutLine>& lines)
      : mesh_(mesh), planes_(planes) {
    face_.plane = plane;
    face_.sheet = Unrolled(planes, planes[plane].sheet);
    int exponent = 0;
    std::frexp(planes.tolerance, &exponent);
    grid_ = std::ldexp(1.0, exponent - 6);
    face_.segment = std::move(segments);
    for (const CutLine& line : lines) {
      const bool here = std::any_of(line.planes.begin(), line.planes.end(),
                                    [&](int k) { return planes[k].sheet == planes[plane].sheet; });
      if (here) take_line(line);
    }
    take_segments();
    surround();
    triangulation_ = std::make_unique<PlaneTriangulation>(uv_, constraint_);
  }

  void conform(double shortest) { triangulation_->conform(shortest); }

  /// Points spread inside the section, finer near cut segments.
  void sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
    update();
    const std::vector<glm::dvec2> candidates = SizeField(sources(limits.contrast), limits).samples();
    const Regions regions = find_regions(face_, planes_, surfaces, bodies);
    const std::vector<std::int32_t> triangle = triangulation_->locate(candidates);
    std::vector<glm::dvec2> chosen;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (triangle[i] >= 0 && regions.is_section(static_cast<std::size_t>(triangle[i]))) {
        chosen.push_back(candidates[i]);
      }
    }
    triangulation_->insert(chosen);
  }

  /// Takes over the triangulation's present state.
  void update() {
    face_.mesh = triangulation_->state();
    face_.edges.clear();
    for (std::uint32_t s = 0; s < face_.segment.size(); ++s) list_uses(s);
    std::sort(face_.edges.begin(), face_.edges.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
    });
  }

  /// Makes new points of the triangulation points of `mesh`, the one that was built from.
  FaceMesh finish(SplitMesh& mesh, FaceMeshes& all, std::vector<Twins>& twins, Unshared& unshared) {
    for (std::size_t v = face_.point.size(); v < face_.mesh.point.size(); ++v) {
      const glm::dvec2& place = face_.mesh.point[v];
      const std::uint32_t set = mesh.sets.with(0, face_.plane + face_.sheet.facet_at(place.x));
      face_.point.push_back(static_cast<std::uint32_t>(mesh.point.size()));
      mesh.point.push_back(settled(face_.sheet.from_face(place), mesh.sets.planes_in(set), planes_));
      mesh.planes_of.push_back(set);
    }
    for (const MeshEdge& edge : edge_) list_edge_points(edge, all.edge_point);
    list_twins(twins);
    list_unshared(unshared);
    return std::move(face_);
  }

 private:
  std::uint32_t vertex(std::uint32_t point) {
    const auto [entry, is_new] = vertex_of_.try_emplace(point, static_cast<std::uint32_t>(uv_.size()));
    if (is_new) {
      uv_.push_back(snapped(face_.sheet.to_face(facet_of(point), mesh_.point[point])));
      face_.point.push_back(point);
    }
    return entry->second;
  }

  /// The first facet of the sheet that the point lies on.
  int facet_of(std::uint32_t point) const {
    const CutPlanes::Sheet& sheet = planes_.sheet_of(face_.plane);
    if (!sheet.stroke) return 0;
    for (const int k : mesh_.sets.planes_in(mesh_.planes_of[point])) {
      const bool here = k >= sheet.first && k < sheet.first + sheet.count;
      if (here && planes_.is_in_facet(k, mesh_.point[point])) return k - sheet.first;
    }
    return sheet.stroke->nearest(glm::dvec2(mesh_.point[point])).facet;
  }

  /// Points too near to each other for what CGAL computes of them become one.
  glm::dvec2 snapped(const glm::dvec2& p) const { return grid_ * glm::floor(p / grid_ + 0.5); }

  std::uint32_t constraint_between(std::uint32_t p, std::uint32_t q, bool divisible) {
    const auto [entry, is_new] =
        constraint_of_.try_emplace(std::minmax(p, q), static_cast<std::uint32_t>(constraint_.size()));
    if (is_new) {
      constraint_.push_back({vertex(p), vertex(q), divisible});
      leads_outside_.push_back(0);
    }
    return entry->second;
  }

  void take_line(const CutLine& line) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const std::uint32_t c = constraint_between(line.points[i - 1], line.points[i], false);
      leads_outside_[c] = line.leads_outside(i) ? 1 : 0;
      if (!line.leads_outside(i)) line_pieces_.emplace_back(&line, c);
    }
    lines_.push_back(&line);
  }

  void take_segments() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_of;
    for (const Segment& s : face_.segment) {
      const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(s.from, s.to);
      const auto [entry, is_new] = edge_of.try_emplace(ends, static_cast<std::uint32_t>(edge_.size()));
      if (is_new) take_edge(ends.first, ends.second);
      edge_of_segment_.push_back(entry->second);
    }
  }

  void take_edge(std::uint32_t low, std::uint32_t high) {
    MeshEdge edge{low, high, {}};
    const CutLine* line = line_with(low, high);
    std::uint32_t last = low;
    if (line) {
      for (const std::uint32_t p : points_between(*line, low, high)) {
        edge.constraint.push_back(constraint_between(last, p, false));
        last = p;
      }
    }
    edge.constraint.push_back(constraint_between(last, high, line == nullptr));
    edge_.push_back(std::move(edge));
  }

  const CutLine* line_with(std::uint32_t p, std::uint32_t q) {
    const auto lies_on = [&](std::uint32_t point, const CutLine& line) {
      const std::uint32_t set = mesh_.planes_of[point];
      return mesh_.sets.has(set, line.planes[0]) && mesh_.sets.has(set, line.planes[1]);
    };
    for (const CutLine* line : lines_) {
      if (lies_on(p, *line) && lies_on(q, *line)) return line;
    }
    return nullptr;
  }

  /// Four points far outside, so that no constraint lies on the hull.
  void surround() {
    glm::dvec2 low(0), high(0);
    for (std::size_t i = 0; i < uv_.size(); ++i) {
      low = i == 0 ? uv_[i] : glm::min(low, uv_[i]);
      high = i == 0 ? uv_[i] : glm::max(high, uv_[i]);
    }
    const glm::dvec2 center = 0.5 * (low + high);
    const double reach = 2 * std::max(high.x - low.x, high.y - low.y) + 1e-6;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
      uv_.push_back(center + reach * corner);
    }
  }

  /// Constraints as they are now. A plane cuts triangles at random, some only at a corner: so a segment counts with
  /// the mean length of itself and its neighbours on the chain, if that is more than its own.
  std::vector<SizeSource> sources(double contrast) const {
    std::vector<SizeSource> sources;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    std::vector<double> length_at(face_.mesh.point.size(), 0);
    std::vector<int> count_at(face_.mesh.point.size(), 0);
    for (std::size_t c = 0; c < constraint_.size(); ++c) {
      if (leads_outside_[c]) continue;
      const std::vector<std::uint32_t>& chain = face_.mesh.chain[c];
      for (std::size_t i = 1; i < chain.size(); ++i) {
        sources.push_back(source_along(chain[i - 1], chain[i], contrast));
        ends.emplace_back(chain[i - 1], chain[i]);
        for (const std::uint32_t v : {chain[i - 1], chain[i]}) {
          length_at[v] += glm::distance(sources.back().a, sources.back().b);
          ++count_at[v];
        }
      }
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const double own = glm::distance(sources[i].a, sources[i].b);
      double sum = own;
      int count = 1;
      for (const std::uint32_t v : {ends[i].first, ends[i].second}) {
        if (count_at[v] != 2) continue;
        sum += length_at[v] - own;
        ++count;
      }
      sources[i].size *= std::max(own, sum / count);
    }
    return sources;
  }

  /// Where several surfaces lie on one edge, the first counts.
  SizeSource source_along(std::uint32_t from, std::uint32_t to, double contrast) const {
    SizeSource source;
    const std::span<const EdgeUse> uses = face_.uses(from, to);
    if (uses.empty()) {
      source.size = 1;
      source.has_color = false;
    } else {
      source = source_of(face_.segment[uses.front().segment], mesh_, contrast);
      if (uses.front().forward != (from < to)) std::swap(source.left, source.right);
    }
    source.a = face_.mesh.point[from];
    source.b = face_.mesh.point[to];
    return source;
  }

  /// The vertices along an edge, from its low to its high end.
  std::vector<std::uint32_t> chain_of(const MeshEdge& edge) const {
    std::vector<std::uint32_t> all{face_.mesh.stand_in[vertex_of_.at(edge.low)]};
    for (const std::uint32_t c : edge.constraint) {
      std::vector<std::uint32_t> chain = face_.mesh.chain[c];
      if (chain.empty()) continue;
      if (chain.front() != all.back()) std::reverse(chain.begin(), chain.end());
      all.insert(all.end(), chain.begin() + 1, chain.end());
    }
    return all;
  }

  void list_uses(std::uint32_t segment) {
    const bool forward = face_.segment[segment].from < face_.segment[segment].to;
    const std::vector<std::uint32_t> chain = chain_of(edge_[edge_of_segment_[segment]]);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const std::uint32_t p = chain[i - 1], q = chain[i];
      face_.edges.push_back({std::min(p, q), std::max(p, q), segment, forward == (p < q)});
    }
  }

  static std::span<const std::uint32_t> inner(const std::vector<std::uint32_t>& chain) {
    return chain.size() < 3 ? std::span<const std::uint32_t>() : std::span(chain).subspan(1, chain.size() - 2);
  }

  /// The end of a constraint that the vertex cannot be told from; or none.
  std::optional<std::uint32_t> near_end(std::uint32_t vertex_number, std::uint32_t constraint) const {
    for (const std::uint32_t end : {constraint_[constraint].a, constraint_[constraint].b}) {
      if (glm::distance(uv(vertex_number), uv(end)) <= planes_.tolerance) return end;
    }
    return std::nullopt;
  }
  const glm::dvec2& uv(std::uint32_t v) const { return face_.mesh.point[v]; }

  /// Pairs of points that are one place: at equal coordinates, or next to a point of a line.
  void list_twins(std::vector<Twins>& twins) const {
    for (std::size_t v = 0; v < face_.mesh.stand_in.size(); ++v) {
      if (face_.mesh.stand_in[v] != v) twins.emplace_back(face_.point[face_.mesh.stand_in[v]], face_.point[v]);
    }
    for (const auto& [line, c] : line_pieces_) {
      for (const std::uint32_t v : inner(face_.mesh.chain[c])) {
        if (const auto end = near_end(v, c)) twins.emplace_back(face_.point[*end], face_.point[v]);
      }
    }
  }

  /// Points that crossing surfaces have put on lines after these were laid out. The other planes must have them too.
  void list_unshared(Unshared& unshared) const {
    for (const auto& [line, c] : line_pieces_) {
      for (const std::uint32_t v : inner(face_.mesh.chain[c])) {
        if (!near_end(v, c)) unshared[line].push_back(face_.point[v]);
      }
    }
  }

  void list_edge_points(const MeshEdge& edge, std::vector<EdgePoint>& edge_points) const {
    const std::vector<std::uint32_t> chain = chain_of(edge);
    const glm::dvec3& start = mesh_.point[edge.low];
    const double length = glm::distance(start, mesh_.point[edge.high]);
    double share = 0;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const std::uint32_t point = face_.point[chain[i]];
      const double measured = glm::distance(start, mesh_.point[point]) / length;
      share = std::max(measured, std::nextafter(share, 2.0));  // the order along the chain, whatever rounding says
      edge_points.push_back({edge.low, edge.high, share, point});
    }
  }

  const SplitMesh& mesh_;
  const CutPlanes& planes_;
  FaceMesh face_;
  double grid_ = 0;  // a power of two, less than the tolerance
  std::vector<const CutLine*> lines_;
  std::vector<glm::dvec2> uv_;
  std::vector<PlaneConstraint> constraint_;
  std::vector<std::uint8_t> leads_outside_;                            // per constraint: the end of a line
  std::vector<std::pair<const CutLine*, std::uint32_t>> line_pieces_;  // with their constraints
  std::vector<MeshEdge> edge_;
  std::vector<std::uint32_t> edge_of_segment_;
  std::map<std::uint32_t, std::uint32_t> vertex_of_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> constraint_of_;
  std::unique_ptr<PlaneTriangulation> triangulation_;
};

/// For each of `count` points the first of those it shares its place with.
std::vector<std::uint32_t> first_twins(std::size_t count, const std::vector<Twins>& pairs) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const auto& [a, b] : pairs) {
    const std::uint32_t ra = root(a), rb = root(b);
    parent[std::max(ra, rb)] = std::min(ra, rb);
  }
  for (std::uint32_t p = 0; p < count; ++p) parent[p] = root(p);
  return parent;
}

/// Constraints are not halved below this share of the finest size.
constexpr double shortest_share = 0.25;

constexpr int most_rounds = 4;

/// Lines need their sizes only roughly, and there may be many planes.
constexpr int line_grid = 48;

/// The lines in which planes meet, as fine as the finer of their planes wants them.
std::vector<CutLine> laid_out_lines(SplitMesh& mesh, const CutPlanes& planes,
                                    const std::vector<std::vector<Segment>>& segments, const Bounds& bounds,
                                    const SizeLimits& limits, Threads threads) {
  std::vector<CutLine> lines = cut_lines(mesh, planes, segments, bounds);
  if (lines.empty()) return lines;
  std::vector<CutFace> frames;
  for (int k = 0; k < planes.count(); ++k) frames.push_back(frame_of(planes[k].plane));
  std::vector<std::optional<SizeField>> fields(frames.size());
  parallel_for(fields.size(), threads, [&](std::size_t k) {
    std::vector<SizeSource> sources;
    for (const Segment& s : segments[k]) {
      const glm::dvec2 a = to_face(frames[k], mesh.point[s.from]), b = to_face(frames[k], mesh.point[s.to]);
      sources.push_back(source_of(s, mesh, limits.contrast));
      sources.back().a = a;
      sources.back().b = b;
      sources.back().size *= glm::distance(a, b);
    }
    fields[k].emplace(sources, limits, line_grid);
  });
  const auto size = [&](int plane, const glm::dvec3& p) {
    const auto k = static_cast<std::size_t>(plane);
    return fields[k]->at(to_face(frames[k], p));
  };
  for (CutLine& line : lines) subdivide(line, mesh, planes, size);
  return lines;
}

std::vector<std::vector<Segment>> by_sheet(const CutPlanes& planes, const std::vector<std::vector<Segment>>& segments) {
  std::vector<std::vector<Segment>> of_sheet(planes.sheets.size());
  for (int k = 0; k < planes.count(); ++k) {
    const std::vector<Segment>& of_plane = segments[static_cast<std::size_t>(k)];
    std::vector<Segment>& all = of_sheet[static_cast<std::size_t>(planes[k].sheet)];
    all.insert(all.end(), of_plane.begin(), of_plane.end());
  }
  return of_sheet;
}

}  // namespace

FaceMeshes triangulate(SplitMesh& mesh, const CutPlanes& planes, const std::vector<std::vector<Segment>>& segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options) {
  const Bounds bounds = bounds_of(surfaces);
  const double size = glm::length(bounds.size());
  const SizeLimits limits{options.coarsest * size, options.finest * size, options.grading, options.contrast};
  std::vector<CutLine> lines = laid_out_lines(mesh, planes, segments, bounds, limits, options.threads);
  const std::vector<std::vector<Segment>> of_sheet = by_sheet(planes, segments);

  // A crossing on a line is news to the other planes there: then all start again. Once is nearly always enough.
  for (int round = 1;; ++round) {
    FaceMeshes all;
    std::vector<Twins> twins;
    Unshared unshared;
    std::vector<std::optional<FaceBuilder>> builders(planes.sheets.size());
    parallel_for(builders.size(), options.threads, [&](std::size_t sheet) {
      if (of_sheet[sheet].empty()) return;
      FaceBuilder& builder = builders[sheet].emplace(mesh, planes, planes.sheets[sheet].first, of_sheet[sheet], lines);
      builder.conform(shortest_share * limits.finest);
      builder.sample(limits, surfaces, bodies);
      builder.conform(shortest_share * limits.finest);
      builder.update();
    });
    for (std::optional<FaceBuilder>& builder : builders) {
      if (builder) all.faces.push_back(builder->finish(mesh, all, twins, unshared));
    }
    if (!unshared.empty() && round < most_rounds) {
      for (CutLine& line : lines) insert(line, unshared[&line], mesh);
      continue;
    }
    std::sort(all.edge_point.begin(), all.edge_point.end());
    all.edge_point.erase(std::unique(all.edge_point.begin(), all.edge_point.end()), all.edge_point.end());
    all.same_as = first_twins(mesh.point.size(), twins);
    return all;
  }
}

}  // namespace pomona
