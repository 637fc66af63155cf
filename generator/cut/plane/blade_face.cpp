#include "generator/cut/plane/blade_face.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/plane/plane_regions.h"
#include "generator/cut/section/segment_source.h"

namespace pomona {

BladeFaceBuilder::BladeFaceBuilder(const SplitMesh& mesh, const CutPlanes& planes, int plane,
                                   std::vector<CutSegment> segments, const std::vector<CutLine>& lines)
    : mesh_(mesh), planes_(planes), all_lines_(lines) {
  made_.face.plane = plane;
  blade_ = UnrolledBlade(planes, planes[plane].blade);
  int exponent = 0;
  std::frexp(planes.tolerance, &exponent);
  grid_ = std::ldexp(1.0, exponent - 6);
  made_.face.segment = std::move(segments);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const bool here = std::any_of(lines[l].planes.begin(), lines[l].planes.end(),
                                  [&](int k) { return planes[k].blade == planes[plane].blade; });
    if (here) take_line(l);
  }
  take_segments();
  surround();
  triangulation_ = std::make_unique<PlaneTriangulation>(uv_, constraint_);
}

void BladeFaceBuilder::sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  update();
  const std::vector<glm::dvec2> candidates = SizeField(sources(limits.contrast), limits).samples();
  const Regions regions = plane_regions(made_.face, planes_, surfaces, bodies);
  const std::vector<std::int32_t> triangle = triangulation_->locate(candidates);
  std::vector<glm::dvec2> chosen;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (triangle[i] >= 0 && regions.is_section(static_cast<std::size_t>(triangle[i]))) {
      chosen.push_back(candidates[i]);
    }
  }
  triangulation_->insert(chosen);
}

void BladeFaceBuilder::update() {
  flat_ = triangulation_->state();
  Face& face = made_.face;
  face.triangle = flat_.triangle;
  face.neighbor = flat_.neighbor;
  face.constrained = flat_.constrained;
  face.place.clear();
  for (const glm::dvec2& p : flat_.point) face.place.push_back(blade_.from_face(p));
  face.edges.clear();
  for (std::uint32_t s = 0; s < face.segment.size(); ++s) list_uses(s);
  face.sort_edges();
}

BladeFace BladeFaceBuilder::finish(std::uint32_t first_new) && {
  number_new_points(first_new);
  find_facets();
  for (const MeshEdge& edge : edge_) list_edge_points(edge, first_new);
  made_.twins = twins();
  made_.unshared = unshared();
  return std::move(made_);
}

void BladeFaceBuilder::number_new_points(std::uint32_t first_new) {
  for (std::size_t v = made_.face.point.size(); v < flat_.point.size(); ++v) {
    const int plane = made_.face.plane + blade_.facet_at(flat_.point[v].x);
    made_.face.point.push_back(first_new + static_cast<std::uint32_t>(made_.point.size()));
    made_.point.push_back({snapped_to_planes(made_.face.place[v], {plane}, planes_), plane});
  }
}

/// Finds the facet of each triangle: none reaches over a crease.
void BladeFaceBuilder::find_facets() {
  Face& face = made_.face;
  for (std::size_t i = 0; i < blade_.facets(); ++i) face.frame.push_back(blade_.frame(static_cast<int>(i)));
  for (const glm::uvec3& t : face.triangle) {
    double u = 0;
    for (int i = 0; i < 3; ++i) u += uv(t[i]).x / 3;
    const auto facet = static_cast<std::size_t>(blade_.facet_at(u));
    face.facet.push_back(static_cast<std::uint32_t>(facet));
    face.normal.push_back(
        {blade_.normal_at(facet, uv(t.x)), blade_.normal_at(facet, uv(t.y)), blade_.normal_at(facet, uv(t.z))});
  }
}

std::uint32_t BladeFaceBuilder::vertex(std::uint32_t point) {
  const auto [entry, is_new] = vertex_of_.try_emplace(point, static_cast<std::uint32_t>(uv_.size()));
  if (is_new) {
    uv_.push_back(snapped(blade_.to_face(facet_of(point), mesh_.point[point])));
    made_.face.point.push_back(point);
  }
  return entry->second;
}

int BladeFaceBuilder::facet_of(std::uint32_t point) const {
  const CutPlanes::Blade& blade = planes_.blade_of(made_.face.plane);
  if (!blade.stroke) return 0;
  for (const int k : mesh_.sets.planes_in(mesh_.planes_of[point])) {
    const bool here = k >= blade.first && k < blade.first + blade.count;
    if (here && planes_.is_in_facet(k, mesh_.point[point])) return k - blade.first;
  }
  return blade.stroke->nearest(glm::dvec2(mesh_.point[point])).facet;
}

std::uint32_t BladeFaceBuilder::constraint_between(std::uint32_t p, std::uint32_t q, bool divisible) {
  const auto [constraint, is_new] = constraint_of_.try_emplace({p, q}, static_cast<std::uint32_t>(constraint_.size()));
  if (is_new) {
    constraint_.push_back({vertex(p), vertex(q), divisible});
    leads_outside_.push_back(0);
  }
  return constraint;
}

void BladeFaceBuilder::take_line(std::size_t number) {
  const CutLine& line = all_lines_[number];
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const std::uint32_t c = constraint_between(line.points[i - 1], line.points[i], false);
    leads_outside_[c] = line.leads_outside(i) ? 1 : 0;
    if (!line.leads_outside(i)) line_pieces_.emplace_back(number, c);
  }
  lines_.push_back(number);
}

void BladeFaceBuilder::take_segments() {
  EdgeMap<std::uint32_t> edge_of;
  for (const CutSegment& s : made_.face.segment) {
    const EdgeKey ends(s.from, s.to);
    const auto [edge, is_new] = edge_of.try_emplace(ends, static_cast<std::uint32_t>(edge_.size()));
    edge_of_segment_.push_back(edge);
    if (is_new) take_edge(ends.low, ends.high);
  }
}

void BladeFaceBuilder::take_edge(std::uint32_t low, std::uint32_t high) {
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

const CutLine* BladeFaceBuilder::line_with(std::uint32_t p, std::uint32_t q) {
  const auto lies_on = [&](std::uint32_t point, const CutLine& line) {
    const std::uint32_t set = mesh_.planes_of[point];
    return mesh_.sets.has(set, line.planes[0]) && mesh_.sets.has(set, line.planes[1]);
  };
  for (const std::size_t number : lines_) {
    const CutLine& line = all_lines_[number];
    if (lies_on(p, line) && lies_on(q, line)) return &line;
  }
  return nullptr;
}

void BladeFaceBuilder::surround() {
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

std::vector<SizeSource> BladeFaceBuilder::sources(double contrast) const {
  // Collect the edges along constraints, and the lengths of the edges that meet at each vertex.
  std::vector<SizeSource> sources;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  std::vector<double> length_at(flat_.point.size(), 0);
  std::vector<int> count_at(flat_.point.size(), 0);
  for (std::size_t c = 0; c < constraint_.size(); ++c) {
    if (leads_outside_[c]) continue;
    const std::vector<std::uint32_t>& chain = flat_.chain[c];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      sources.push_back(source_along(chain[i - 1], chain[i], contrast));
      ends.emplace_back(chain[i - 1], chain[i]);
      for (const std::uint32_t v : {chain[i - 1], chain[i]}) {
        length_at[v] += glm::distance(sources.back().a, sources.back().b);
        ++count_at[v];
      }
    }
  }

  // Take the mean over each edge and its neighbours on the chain, if that is longer than the edge.
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

SizeSource BladeFaceBuilder::source_along(std::uint32_t from, std::uint32_t to, double contrast) const {
  SizeSource source;
  const std::span<const EdgeUse> uses = made_.face.uses(from, to);
  if (uses.empty()) {
    source.size = 1;
    source.has_color = false;
  } else {
    source = source_of(made_.face.segment[uses.front().segment], mesh_, contrast);
    if (uses.front().forward != (from < to)) std::swap(source.left, source.right);
  }
  source.a = flat_.point[from];
  source.b = flat_.point[to];
  return source;
}

std::vector<std::uint32_t> BladeFaceBuilder::chain_of(const MeshEdge& edge) const {
  std::vector<std::uint32_t> all{flat_.stand_in[vertex_of_.at(edge.low)]};
  for (const std::uint32_t c : edge.constraint) {
    std::vector<std::uint32_t> chain = flat_.chain[c];
    if (chain.empty()) continue;
    if (chain.front() != all.back()) std::reverse(chain.begin(), chain.end());
    all.insert(all.end(), chain.begin() + 1, chain.end());
  }
  return all;
}

void BladeFaceBuilder::list_uses(std::uint32_t segment) {
  const bool forward = made_.face.segment[segment].from < made_.face.segment[segment].to;
  const std::vector<std::uint32_t> chain = chain_of(edge_[edge_of_segment_[segment]]);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const std::uint32_t p = chain[i - 1], q = chain[i];
    made_.face.edges.push_back({std::min(p, q), std::max(p, q), segment, forward == (p < q)});
  }
}

std::span<const std::uint32_t> BladeFaceBuilder::inner(const std::vector<std::uint32_t>& chain) {
  return chain.size() < 3 ? std::span<const std::uint32_t>() : std::span(chain).subspan(1, chain.size() - 2);
}

std::optional<std::uint32_t> BladeFaceBuilder::near_end(std::uint32_t vertex_number, std::uint32_t constraint) const {
  for (const std::uint32_t end : {constraint_[constraint].a, constraint_[constraint].b}) {
    if (glm::distance(uv(vertex_number), uv(end)) <= planes_.tolerance) return end;
  }
  return std::nullopt;
}

std::vector<Twins> BladeFaceBuilder::twins() const {
  std::vector<Twins> found;
  const std::vector<std::uint32_t>& point = made_.face.point;
  for (std::size_t v = 0; v < flat_.stand_in.size(); ++v) {
    if (flat_.stand_in[v] != v) found.emplace_back(point[flat_.stand_in[v]], point[v]);
  }
  for (const auto& [line, c] : line_pieces_) {
    for (const std::uint32_t v : inner(flat_.chain[c])) {
      if (const auto end = near_end(v, c)) found.emplace_back(point[*end], point[v]);
    }
  }
  return found;
}

Unshared BladeFaceBuilder::unshared() const {
  Unshared found;
  for (const auto& [line, c] : line_pieces_) {
    for (const std::uint32_t v : inner(flat_.chain[c])) {
      if (!near_end(v, c)) found[line].push_back(made_.face.point[v]);
    }
  }
  return found;
}

void BladeFaceBuilder::list_edge_points(const MeshEdge& edge, std::uint32_t first_new) {
  const auto place_of = [&](std::uint32_t p) {
    return p < first_new ? mesh_.point[p] : made_.point[p - first_new].place;
  };
  const std::vector<std::uint32_t> chain = chain_of(edge);
  const glm::dvec3& start = mesh_.point[edge.low];
  const double length = glm::distance(start, mesh_.point[edge.high]);
  double share = 0;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const std::uint32_t point = made_.face.point[chain[i]];
    const double measured = glm::distance(start, place_of(point)) / length;
    share = std::max(measured, std::nextafter(share, 2.0));  // rounding must not change the order along the chain
    made_.edge_point.push_back({edge.low, edge.high, share, point});
  }
}

}  // namespace pomona
