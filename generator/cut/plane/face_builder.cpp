#include "generator/cut/plane/face_builder.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/section/regions.h"
#include "generator/cut/section/segment_source.h"

namespace pomona {

FaceBuilder::FaceBuilder(const SplitMesh& mesh, const CutPlanes& planes, int plane, std::vector<Segment> segments,
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

void FaceBuilder::sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
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

void FaceBuilder::update() {
  face_.mesh = triangulation_->state();
  face_.edges.clear();
  for (std::uint32_t s = 0; s < face_.segment.size(); ++s) list_uses(s);
  std::sort(face_.edges.begin(), face_.edges.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
}

FaceMesh FaceBuilder::finish(SplitMesh& mesh, FaceMeshes& all, std::vector<Twins>& twins, Unshared& unshared) {
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

std::uint32_t FaceBuilder::vertex(std::uint32_t point) {
  const auto [entry, is_new] = vertex_of_.try_emplace(point, static_cast<std::uint32_t>(uv_.size()));
  if (is_new) {
    uv_.push_back(snapped(face_.sheet.to_face(facet_of(point), mesh_.point[point])));
    face_.point.push_back(point);
  }
  return entry->second;
}

int FaceBuilder::facet_of(std::uint32_t point) const {
  const CutPlanes::Sheet& sheet = planes_.sheet_of(face_.plane);
  if (!sheet.stroke) return 0;
  for (const int k : mesh_.sets.planes_in(mesh_.planes_of[point])) {
    const bool here = k >= sheet.first && k < sheet.first + sheet.count;
    if (here && planes_.is_in_facet(k, mesh_.point[point])) return k - sheet.first;
  }
  return sheet.stroke->nearest(glm::dvec2(mesh_.point[point])).facet;
}

std::uint32_t FaceBuilder::constraint_between(std::uint32_t p, std::uint32_t q, bool divisible) {
  const auto [entry, is_new] =
      constraint_of_.try_emplace(std::minmax(p, q), static_cast<std::uint32_t>(constraint_.size()));
  if (is_new) {
    constraint_.push_back({vertex(p), vertex(q), divisible});
    leads_outside_.push_back(0);
  }
  return entry->second;
}

void FaceBuilder::take_line(const CutLine& line) {
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const std::uint32_t c = constraint_between(line.points[i - 1], line.points[i], false);
    leads_outside_[c] = line.leads_outside(i) ? 1 : 0;
    if (!line.leads_outside(i)) line_pieces_.emplace_back(&line, c);
  }
  lines_.push_back(&line);
}

void FaceBuilder::take_segments() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_of;
  for (const Segment& s : face_.segment) {
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(s.from, s.to);
    const auto [entry, is_new] = edge_of.try_emplace(ends, static_cast<std::uint32_t>(edge_.size()));
    if (is_new) take_edge(ends.first, ends.second);
    edge_of_segment_.push_back(entry->second);
  }
}

void FaceBuilder::take_edge(std::uint32_t low, std::uint32_t high) {
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

const CutLine* FaceBuilder::line_with(std::uint32_t p, std::uint32_t q) {
  const auto lies_on = [&](std::uint32_t point, const CutLine& line) {
    const std::uint32_t set = mesh_.planes_of[point];
    return mesh_.sets.has(set, line.planes[0]) && mesh_.sets.has(set, line.planes[1]);
  };
  for (const CutLine* line : lines_) {
    if (lies_on(p, *line) && lies_on(q, *line)) return line;
  }
  return nullptr;
}

void FaceBuilder::surround() {
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

std::vector<SizeSource> FaceBuilder::sources(double contrast) const {
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

SizeSource FaceBuilder::source_along(std::uint32_t from, std::uint32_t to, double contrast) const {
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

std::vector<std::uint32_t> FaceBuilder::chain_of(const MeshEdge& edge) const {
  std::vector<std::uint32_t> all{face_.mesh.stand_in[vertex_of_.at(edge.low)]};
  for (const std::uint32_t c : edge.constraint) {
    std::vector<std::uint32_t> chain = face_.mesh.chain[c];
    if (chain.empty()) continue;
    if (chain.front() != all.back()) std::reverse(chain.begin(), chain.end());
    all.insert(all.end(), chain.begin() + 1, chain.end());
  }
  return all;
}

void FaceBuilder::list_uses(std::uint32_t segment) {
  const bool forward = face_.segment[segment].from < face_.segment[segment].to;
  const std::vector<std::uint32_t> chain = chain_of(edge_[edge_of_segment_[segment]]);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const std::uint32_t p = chain[i - 1], q = chain[i];
    face_.edges.push_back({std::min(p, q), std::max(p, q), segment, forward == (p < q)});
  }
}

std::span<const std::uint32_t> FaceBuilder::inner(const std::vector<std::uint32_t>& chain) {
  return chain.size() < 3 ? std::span<const std::uint32_t>() : std::span(chain).subspan(1, chain.size() - 2);
}

std::optional<std::uint32_t> FaceBuilder::near_end(std::uint32_t vertex_number, std::uint32_t constraint) const {
  for (const std::uint32_t end : {constraint_[constraint].a, constraint_[constraint].b}) {
    if (glm::distance(uv(vertex_number), uv(end)) <= planes_.tolerance) return end;
  }
  return std::nullopt;
}

void FaceBuilder::list_twins(std::vector<Twins>& twins) const {
  for (std::size_t v = 0; v < face_.mesh.stand_in.size(); ++v) {
    if (face_.mesh.stand_in[v] != v) twins.emplace_back(face_.point[face_.mesh.stand_in[v]], face_.point[v]);
  }
  for (const auto& [line, c] : line_pieces_) {
    for (const std::uint32_t v : inner(face_.mesh.chain[c])) {
      if (const auto end = near_end(v, c)) twins.emplace_back(face_.point[*end], face_.point[v]);
    }
  }
}

void FaceBuilder::list_unshared(Unshared& unshared) const {
  for (const auto& [line, c] : line_pieces_) {
    for (const std::uint32_t v : inner(face_.mesh.chain[c])) {
      if (!near_end(v, c)) unshared[line].push_back(face_.point[v]);
    }
  }
}

void FaceBuilder::list_edge_points(const MeshEdge& edge, std::vector<EdgePoint>& edge_points) const {
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

}  // namespace pomona
