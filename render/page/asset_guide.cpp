#include "render/page/asset_guide.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/piece/guided.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

/// Largest stored value: patterns do not show a thousandth of a fruit's size, and small numbers pack well.
constexpr double max_units = 1023;

bool has_details(const Template& fruit, DetailFace face) {
  return std::any_of(fruit.details.begin(), fruit.details.end(), [&](const DetailSketch& d) { return d.face == face; });
}

/// Template parts by their indices among the surfaces' parts.
std::int32_t part_in_template(const Template& fruit, const std::string& name) {
  const auto found = std::find(fruit.parts.begin(), fruit.parts.end(), name);
  return found == fruit.parts.end() ? -1 : static_cast<std::int32_t>(found - fruit.parts.begin());
}

glm::u8vec4 in_bytes(const glm::vec4& share) { return glm::u8vec4(glm::clamp(share, 0.0f, 1.0f) * 255.0f + 0.5f); }

struct CoarseNodes {
  std::vector<std::size_t> index;  ///< among the guide's nodes
  std::vector<glm::vec3> place;
  std::vector<std::uint8_t> inside;
};

/// Coarse nodes with an inner fine node in the cells around them.
CoarseNodes nodes_in_use(const Asset& asset, const AssetGuide& guide) {
  CoarseNodes nodes;
  const auto winding = [&](const glm::ivec3& p) {
    return asset.winding[(static_cast<std::size_t>(p.z) * static_cast<std::size_t>(asset.count[1]) +
                          static_cast<std::size_t>(p.y)) *
                             static_cast<std::size_t>(asset.count[0]) +
                         static_cast<std::size_t>(p.x)];
  };
  const glm::ivec3 last(asset.count[0] - 1, asset.count[1] - 1, asset.count[2] - 1);
  const auto any_near = [&](const glm::ivec3& middle) {
    const glm::ivec3 low = glm::max(middle - guide.stride, glm::ivec3(0)), high = glm::min(middle + guide.stride, last);
    for (glm::ivec3 p = low; p.z <= high.z; ++p.z)
      for (p.y = low.y; p.y <= high.y; ++p.y)
        for (p.x = low.x; p.x <= high.x; ++p.x)
          if (winding(p) != 0) return true;
    return false;
  };
  std::size_t index = 0;
  for (int z = 0; z < guide.count[2]; ++z) {
    for (int y = 0; y < guide.count[1]; ++y) {
      for (int x = 0; x < guide.count[0]; ++x, ++index) {
        const glm::ivec3 node = glm::ivec3(x, y, z) * guide.stride;
        if (!any_near(node)) continue;
        nodes.index.push_back(index);
        nodes.place.emplace_back(asset.origin + asset.spacing * glm::dvec3(node));
        nodes.inside.push_back(winding(node) != 0 ? 1 : 0);
      }
    }
  }
  return nodes;
}

/// The guides of places. Without directed details the ways only need their lengths, the depths.
std::vector<DetailGuide> guides_of(const std::vector<glm::vec3>& places, const GrownFruit& grown, const Template& fruit,
                                   Threads threads) {
  const SkinDepth own = grown.skin ? SkinDepth({}) : SkinDepth(grown.swept);
  const SkinDepth& skin = grown.skin ? *grown.skin : own;
  if (has_directed_details(fruit)) return layer_guides(places, grown.swept, fruit, skin, threads);
  const std::vector<glm::dvec3> points(places.begin(), places.end());
  const std::vector<double> depth = skin.depths(points, std::numeric_limits<double>::infinity(), threads);
  std::vector<DetailGuide> guides(places.size());
  for (std::size_t i = 0; i < depth.size(); ++i) guides[i].to_skin.x = static_cast<float>(depth[i]);
  return guides;
}

}  // namespace

void add_guide(const GrownFruit& grown, const Template& fruit, Threads threads, Asset& asset) {
  if (has_details(fruit, DetailFace::skin)) {
    for (const std::string& part : asset.parts)
      asset.skin_share.push_back(in_bytes(detail_shares(fruit, DetailFace::skin, part_in_template(fruit, part), 0)));
  }
  if (!has_details(fruit, DetailFace::cut)) return;

  // A grid of every eighth node; its last plane lies on or beyond the lattice's.
  AssetGuide guide;
  for (std::size_t axis = 0; axis < 3; ++axis)
    guide.count[axis] = (asset.count[axis] + guide.stride - 2) / guide.stride + 1;
  const CoarseNodes nodes = nodes_in_use(asset, guide);
  const std::vector<DetailGuide> guides = guides_of(nodes.place, grown, fruit, threads);

  // Rounds values in units of the largest.
  double largest = 1e-6;
  for (const DetailGuide& at : guides) {
    const glm::vec3 way = glm::abs(at.to_skin);
    largest = std::max<double>({largest, way.x, way.y, way.z, std::fabs(at.layer)});
    guide.deepest = std::max<double>(guide.deepest, glm::length(at.to_skin));
  }
  guide.unit = largest / max_units;
  guide.value.assign(static_cast<std::size_t>(guide.count[0]) * static_cast<std::size_t>(guide.count[1]) *
                         static_cast<std::size_t>(guide.count[2]),
                     glm::i16vec4(0));
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const DetailGuide& at = guides[i];
    const glm::dvec4 value(glm::dvec3(at.to_skin) * (nodes.inside[i] != 0 ? 1.0 : -1.0), at.layer);
    guide.value[nodes.index[i]] = glm::i16vec4(glm::floor(value / guide.unit + 0.5));
  }

  // The weight of each detail, by part and depth.
  guide.deepest = std::max(guide.deepest, 1e-6);
  for (const std::string& part : asset.parts) {
    for (int step = 0; step < depth_steps; ++step) {
      const double depth = guide.deepest * step / (depth_steps - 1);
      guide.share.push_back(in_bytes(detail_shares(fruit, DetailFace::cut, part_in_template(fruit, part), depth)));
    }
  }
  asset.guide = std::move(guide);
}

}  // namespace pomona
