#include "render/picture/section_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "render/picture/chains.h"
#include "render/picture/line_opacity.h"

namespace pomona {

namespace {

/// All facets of a stroke are one face: the first of them that has triangles.
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

/// Collects the edges of all triangles, face by face.
std::vector<HalfEdge> half_edges_of(const CrossSection& section, const std::vector<std::uint32_t>& place) {
  const std::vector<int> whole = unrolled_faces(section);
  std::vector<std::int32_t> face;
  for (const int facet : section.cut) face.push_back(whole[static_cast<std::size_t>(facet)]);
  return sorted_half_edges(welded_triangles(place, section.triangle), {.kind = face, .of_collapsed = true});
}

/// Lines of one kind, to be chained together: those of a face's rim, or of one surface on it.
struct Bundle {
  std::vector<ChainLink> links;
  std::vector<double> opacity;          // per link
  std::vector<std::uint32_t> opposite;  // per link: the inner vertex beside it
  std::vector<int> facet;               // per link
};
using BundleKey = std::tuple<int, int>;  // face; surface, or -1 for the rim

double color_jump(const CrossSection& section, const HalfEdge& x, const HalfEdge& y) {
  const auto apart = [&](std::uint32_t v, std::uint32_t w) {
    return static_cast<double>(glm::distance(to_oklab(section.color[v]), to_oklab(section.color[w])));
  };
  const glm::uvec2 v = ends_in(section.triangle, x), w = ends_in(section.triangle, y);
  return 0.5 * (apart(v.x, w.x) + apart(v.y, w.y));
}

std::map<BundleKey, Bundle> bundles_of(const CrossSection& section, const std::vector<std::uint32_t>& place) {
  EdgeMap<int> surface_of;
  for (const SectionSegment& segment : section.segments)
    surface_of.try_emplace({place[segment.vertex[0]], place[segment.vertex[1]]}, segment.surface);

  // An edge with one triangle is the rim; with two, and on a cut segment, it is an inner line.
  std::map<BundleKey, Bundle> bundles;
  for_each_edge(half_edges_of(section, place), [&](std::span<const HalfEdge> edge) {
    const HalfEdge& h = edge.front();
    const int* surface = surface_of.find({h.low, h.high});
    const bool rim = edge.size() == 1;
    const double opacity = rim ? 1.0 : edge.size() == 2 ? line_opacity(color_jump(section, h, edge[1])) : 0.0;
    if (!(opacity > 0) || (!rim && !surface)) return;
    Bundle& bundle = bundles[{h.kind, rim ? -1 : *surface}];
    bundle.links.push_back({h.low, h.high});
    bundle.opacity.push_back(opacity);
    bundle.opposite.push_back(section.triangle[h.triangle][(h.side + 2) % 3]);
    bundle.facet.push_back(section.cut[h.triangle]);
  });
  return bundles;
}

/// The side of the line on which most of the face lies: +1 left, -1 right, seen with y down.
double side_of_face(const Chain& chain, const Bundle& bundle, const std::vector<glm::dvec2>& places) {
  double balance = 0;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const ChainLink& link = bundle.links[chain.links[i]];
    const glm::dvec2 a = places[link.a];
    const glm::dvec2 d = places[link.b] - a;
    const glm::dvec2 c = places[bundle.opposite[chain.links[i]]] - a;
    balance += cross(d, c) * (chain.forward[i] != 0 ? 1.0 : -1.0);
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

    // Only this bundle's vertices need a place on this face. Facets agree on it where they meet.
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
