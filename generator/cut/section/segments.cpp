#include "generator/cut/section/segments.h"

#include <algorithm>
#include <tuple>

namespace pomona {

std::vector<CutSegment> without_mere_touches(std::vector<CutSegment> segments, const DiffusionSurfaces& surfaces,
                                             const Bodies& bodies) {
  struct Entry {
    std::uint32_t low, high;
    std::int32_t surface, body;
    bool forward;
    std::uint32_t index;
    auto key() const { return std::tie(low, high, surface, body); }
  };

  // Sort uses of edges: by edge, body and surface, forward ones first.
  std::vector<Entry> entries;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const CutSegment& s = segments[i];
    entries.push_back({std::min(s.from, s.to), std::max(s.from, s.to), surfaces.surface[s.source],
                       bodies.of_triangle[s.source], s.from < s.to, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(a.key(), !a.forward, a.index) < std::tuple(b.key(), !b.forward, b.index);
  });

  // Of each edge, cancel forward uses with backward ones.
  std::vector<std::uint8_t> keep(segments.size(), 1);
  for (std::size_t i = 0; i < entries.size();) {
    std::size_t forward = i, end;
    while (forward < entries.size() && entries[forward].key() == entries[i].key() && entries[forward].forward)
      ++forward;
    for (end = forward; end < entries.size() && entries[end].key() == entries[i].key(); ++end) {
    }
    const std::size_t pairs = std::min(forward - i, end - forward);
    for (std::size_t k = 0; k < pairs; ++k) keep[entries[i + k].index] = keep[entries[forward + k].index] = 0;
    i = end;
  }

  // Keep the order of the others.
  std::vector<CutSegment> kept;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (keep[i]) kept.push_back(segments[i]);
  }
  return kept;
}

std::vector<std::vector<CutSegment>> cut_segments(const SplitMesh& mesh, const DiffusionSurfaces& surfaces,
                                                  const Bodies& bodies, int planes) {
  std::vector<std::vector<CutSegment>> segments(static_cast<std::size_t>(planes));
  for (const SplitMesh::Triangle& t : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t.cut_by[i] == 0) continue;
      const std::uint32_t from = t.vertex[i], to = t.vertex[(i + 1) % 3];
      for (const int plane : mesh.sets.planes_in(t.cut_by[i])) {
        segments[static_cast<std::size_t>(plane)].push_back(
            {mesh.point_of[from], mesh.point_of[to], from, to, t.source});
      }
    }
  }
  for (std::vector<CutSegment>& s : segments) s = without_mere_touches(std::move(s), surfaces, bodies);
  return segments;
}

}  // namespace pomona
