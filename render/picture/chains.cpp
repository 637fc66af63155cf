#include "render/picture/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr std::uint32_t none = ~0u;

/// One end of a link; `end` 0 is a, 1 is b. Joined ends continue each other.
struct LinkEnd {
  std::uint32_t node = 0;
  std::uint32_t link = 0;
  std::uint32_t end = 0;
};

/// For each link and each of its ends: index 2 link + end of the end it is joined to, or none.
using Joints = std::vector<std::uint32_t>;

glm::dvec2 direction_away(const LinkEnd& e, std::span<const ChainLink> links, std::span<const glm::dvec2> nodes) {
  const ChainLink& link = links[e.link];
  const glm::dvec2 d = e.end == 0 ? nodes[link.b] - nodes[link.a] : nodes[link.a] - nodes[link.b];
  const double size = std::sqrt(glm::dot(d, d));
  return size > 0 ? d / size : glm::dvec2(0);
}

/// Joins the ends that meet in one node, straightest pairs first.
void join(std::span<const LinkEnd> ends, std::span<const ChainLink> links, std::span<const glm::dvec2> nodes,
          Joints& joints) {
  // Where only two meet, they are joined unless they turn back (by more than 120 degrees); else up to 60 degrees.
  const double min = ends.size() == 2 ? -0.5 : 0.5;
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const double straight = -glm::dot(direction_away(ends[i], links, nodes), direction_away(ends[j], links, nodes));
      if (straight < min || ends[i].link == ends[j].link) continue;
      pairs.emplace_back(-straight, 2 * ends[i].link + ends[i].end, 2 * ends[j].link + ends[j].end);
    }
  }

  std::sort(pairs.begin(), pairs.end());
  for (const auto& [bend, first, second] : pairs) {
    if (joints[first] != none || joints[second] != none) continue;
    joints[first] = second;
    joints[second] = first;
  }
}

Joints all_joints(std::span<const ChainLink> links, std::span<const glm::dvec2> nodes) {
  std::vector<LinkEnd> ends;
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    ends.push_back({links[i].a, i, 0});
    ends.push_back({links[i].b, i, 1});
  }
  std::stable_sort(ends.begin(), ends.end(), [](const LinkEnd& x, const LinkEnd& y) { return x.node < y.node; });

  // A node where very many meet stays unjoined, so that the pairs are few.
  constexpr std::size_t max = 32;
  Joints joints(2 * links.size(), none);
  for (std::size_t i = 0; i < ends.size();) {
    std::size_t j = i;
    while (j < ends.size() && ends[j].node == ends[i].node) ++j;
    if (j - i <= max) join(std::span(ends).subspan(i, j - i), links, nodes, joints);
    i = j;
  }
  return joints;
}

/// Follows links from this one, entered at `end`, until the line ends or closes.
Chain walk(std::uint32_t link, std::uint32_t end, const Joints& joints, std::vector<std::uint8_t>& taken) {
  Chain chain;
  while (true) {
    taken[link] = 1;
    chain.links.push_back(link);
    chain.forward.push_back(end == 0);
    const std::uint32_t next = joints[2 * link + (1 - end)];
    if (next == none) return chain;
    if (taken[next / 2] != 0) {
      chain.closed = true;
      return chain;
    }
    link = next / 2;
    end = next % 2;
  }
}

}  // namespace

std::vector<Chain> chained(std::span<const ChainLink> links, std::span<const glm::dvec2> nodes) {
  const Joints joints = all_joints(links, nodes);
  std::vector<std::uint8_t> taken(links.size(), 0);
  std::vector<Chain> chains;

  // Open lines start at their ends; the rest are loops.
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    for (std::uint32_t end = 0; end < 2; ++end) {
      if (taken[i] == 0 && joints[2 * i + end] == none) chains.push_back(walk(i, end, joints, taken));
    }
  }
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    if (taken[i] == 0) chains.push_back(walk(i, 0, joints, taken));
  }
  return chains;
}

std::vector<std::uint32_t> nodes_of(const Chain& chain, std::span<const ChainLink> links) {
  std::vector<std::uint32_t> nodes;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const ChainLink& link = links[chain.links[i]];
    nodes.push_back(chain.forward[i] != 0 ? link.a : link.b);
  }
  if (!chain.closed) {
    const ChainLink& last = links[chain.links.back()];
    nodes.push_back(chain.forward.back() != 0 ? last.b : last.a);
  }
  return nodes;
}

}  // namespace pomona
