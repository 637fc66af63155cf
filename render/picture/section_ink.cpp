#include "render/picture/section_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/mesh/welded_edges.h"
#include "render/picture/chains.h"
#include "render/picture/line_opacity.h"

namespace pomona {

namespace {

/// One triangle's share in an edge of a face, named by its welded ends (a < b). All facets of a stroke are one face:
/// the first of them that has triangles.
struct EdgeUse {
  int face = 0, facet = 0;
  std::uint32_t a = 0, b = 0;
  std::uint32_t vertex_a = 0, vertex_b = 0, opposite = 0;
  auto key() const { return std::tuple(face, a, b); }
};

std::vector<int> unrolled_faces(const CrossSection& section) {
  std::vector<int> whole(section.faces.size());
  std::iota(whole.begin(), whole.end(), 0);
  std::map<int, int> first_of_stroke;
  for (const int face : std::set<int>(section.cut.begin(), section.cut.end())) {
    const int stroke = section.faces[static_cast<std::size_t>(face)].stroke;
    if (stroke >= 0) whole[static_cast<std::size_t>(face)] = first_of_stroke.try_emplace(stroke, face).first->second;
  }
  return whole;
}

std::vector<EdgeUse> edge_uses(const CrossSection& section, const std::vector<std::uint32_t>& place) {
  const std::vector<int> whole = unrolled_faces(section);
  std::vector<EdgeUse> uses;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = section.triangle[t][i];
      const std::uint32_t w = section.triangle[t][(i + 1) % 3];
      const std::uint32_t opposite = section.triangle[t][(i + 2) % 3];
      if (place[v] == place[w]) continue;
      const bool turned = place[v] > place[w];
      const int facet = section.cut[t];
      uses.push_back({whole[static_cast<std::size_t>(facet)], facet, place[turned ? w : v], place[turned ? v : w],
                      turned ? w : v, turned ? v : w, opposite});
    }
  }
  std::stable_sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) { return x.key() < y.key(); });
  return uses;
}

/// Lines of one kind, to be chained together: those of a face's rim, or of one surface on it.
struct Bundle {
  std::vector<ChainLink> links;
  std::vector<double> opacity;          // per link
  std::vector<std::uint32_t> opposite;  // per link: the inner vertex beside it
  std::vector<int> facet;               // per link
};
using BundleKey = std::tuple<int, int>;  // face; surface, or -1 for the rim

double color_jump(const CrossSection& section, const EdgeUse& x, const EdgeUse& y) {
  const auto apart = [&](std::uint32_t v, std::uint32_t w) {
    return static_cast<double>(glm::distance(to_oklab(section.color[v]), to_oklab(section.color[w])));
  };
  return 0.5 * (apart(x.vertex_a, y.vertex_a) + apart(x.vertex_b, y.vertex_b));
}

std::map<BundleKey, Bundle> bundles_of(const CrossSection& section, const std::vector<std::uint32_t>& place) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> surface_of;
  for (const SectionSegment& segment : section.segments) {
    surface_of.emplace(std::minmax(place[segment.vertex[0]], place[segment.vertex[1]]), segment.surface);
  }

  // An edge with one triangle is the rim; with two, and on a cut segment, it is an inner line.
  std::map<BundleKey, Bundle> bundles;
  const std::vector<EdgeUse> uses = edge_uses(section, place);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].key() == uses[i].key()) ++j;
    const EdgeUse& use = uses[i];
    const auto segment = surface_of.find({use.a, use.b});
    const bool rim = j - i == 1;
    const double opacity = rim ? 1.0 : j - i == 2 ? line_opacity(color_jump(section, use, uses[i + 1])) : 0.0;
    if (opacity > 0 && (rim || segment != surface_of.end())) {
      Bundle& bundle = bundles[{use.face, rim ? -1 : segment->second}];
      bundle.links.push_back({use.a, use.b});
      bundle.opacity.push_back(opacity);
      bundle.opposite.push_back(use.opposite);
      bundle.facet.push_back(use.facet);
    }
    i = j;
  }
  return bundles;
}

/// Which side of the walk the face lies on, most of the way: +1 left, -1 right as seen with y down.
double side_of_face(const Chain& chain, const Bundle& bundle, const std::vector<glm::dvec2>& places) {
  double balance = 0;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const ChainLink& link = bundle.links[chain.links[i]];
    const glm::dvec2 a = places[link.a];
    const glm::dvec2 d = places[link.b] - a;
    const glm::dvec2 c = places[bundle.opposite[chain.links[i]]] - a;
    balance += (d.x * c.y - d.y * c.x) * (chain.forward[i] != 0 ? 1.0 : -1.0);
  }
  return balance > 0 ? -1.0 : 1.0;
}

PenLine pen_line(const Chain& chain, const Bundle& bundle, const std::vector<glm::dvec2>& nodes) {
  PenLine line{.points = {}, .opacity = {}, .closed = chain.closed};
  const std::vector<std::uint32_t> walk = nodes_of(chain, bundle.links);
  for (std::size_t i = 0; i < walk.size(); ++i) {
    line.points.push_back(nodes[walk[i]]);
    line.opacity.push_back(bundle.opacity[chain.links[std::min(i, chain.links.size() - 1)]]);
  }
  return line;
}

}  // namespace

std::vector<SectionLine> section_lines(const CrossSection& section, const std::vector<PlacedFace>& faces) {
  const std::vector<std::uint32_t> place = weld(section.position);
  std::vector<SectionLine> lines;
  std::vector<glm::dvec2> places(section.position.size(), glm::dvec2(0));
  for (const auto& [key, bundle] : bundles_of(section, place)) {
    const auto [face, surface] = key;
    if (!faces[face].shown) continue;

    // Only this bundle's vertices need a place on this face. Where facets meet they agree on it.
    for (std::size_t i = 0; i < bundle.links.size(); ++i) {
      for (const std::uint32_t v : {bundle.links[i].a, bundle.links[i].b, bundle.opposite[i]}) {
        places[v] = faces[bundle.facet[i]].to_paper(section.position[v]);
      }
    }
    for (const Chain& chain : chained(bundle.links, places)) {
      SectionLine line{.line = pen_line(chain, bundle, places), .face = face, .rim = surface < 0};
      if (line.rim) line.line.weighted_side = side_of_face(chain, bundle, places);
      line.line.key = static_cast<std::uint32_t>(lines.size());
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace pomona
