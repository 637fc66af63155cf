#include "generator/cut/piece_groups.h"

#include <algorithm>
#include <numeric>

#include "generator/mesh/enclosures.h"

namespace pomona {

namespace {

/// Works on the parts of one cell.
class Grouper {
 public:
  Grouper(const std::vector<CutPiece>& parts, std::vector<std::uint32_t> here, const CrossSection& section,
          std::vector<std::uint32_t>& group)
      : parts_(parts), here_(std::move(here)), section_(section), group_(group), meshes_(triangles()) {}

  void run() {
    for (const std::uint32_t part : here_) {
      if (parts_[part].volume < 0) attach_cavity(part);
    }
    // The largest needs no test of its own: every part that overlaps it finds it.
    const std::uint32_t largest = *std::max_element(here_.begin(), here_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return parts_[a].volume < parts_[b].volume;
    });
    for (const std::uint32_t part : here_) {
      if (part != largest && parts_[part].volume >= 0) join_overlapping(part);
    }
  }

 private:
  std::vector<Enclosures::Triangle> triangles() const {
    std::vector<Enclosures::Triangle> all;
    for (const std::uint32_t part : here_) {
      const CutPiece& piece = parts_[part];
      const auto add = [&](const std::vector<glm::vec3>& p, const glm::uvec3& t) {
        all.push_back({{glm::dvec3(p[t.x]), glm::dvec3(p[t.y]), glm::dvec3(p[t.z])}, part});
      };
      for (const glm::uvec3& t : piece.triangle) add(piece.position, t);
      for (const CutPiece::CapTriangle& cap : piece.caps) {
        const glm::uvec3& t = section_.triangle[cap.triangle];
        add(section_.position, cap.reversed ? glm::uvec3(t.x, t.z, t.y) : t);
      }
    }
    return all;
  }

  std::uint32_t root(std::uint32_t part) const {
    while (group_[part] != part) part = group_[part];
    return part;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    group_[std::max(a, b)] = std::min(a, b);
  }

  /// Joins a cavity to the smallest part that winds around one of its vertices. What closed knives leave may have no
  /// vertex of skin, or be connected to another body that sticks out.
  void attach_cavity(std::uint32_t cavity) {
    const CutPiece& piece = parts_[cavity];
    for (const glm::vec3& p : piece.position) {
      if (attach(cavity, p)) return;
    }
    for (const CutPiece::CapTriangle& cap : piece.caps) {
      if (attach(cavity, section_.position[section_.triangle[cap.triangle].x])) return;
    }
  }

  bool attach(std::uint32_t cavity, const glm::vec3& place) {
    std::int64_t home = -1;
    for (const auto& [part, winding] : meshes_.around(glm::dvec3(place))) {
      if (part == cavity || winding <= 0 || parts_[part].volume <= 0) continue;
      if (home < 0 || parts_[part].volume < parts_[static_cast<std::size_t>(home)].volume) home = part;
    }
    if (home >= 0) join(cavity, static_cast<std::uint32_t>(home));
    return home >= 0;
  }

  /// Joins a part to every group in whose solid one of its vertices lies. Walls of cavities count as holes.
  void join_overlapping(std::uint32_t part) {
    for (const glm::vec3& p : parts_[part].position) {
      std::vector<std::pair<std::uint32_t, int>> groups;
      for (const auto& [other, winding] : meshes_.around(glm::dvec3(p))) {
        if (root(other) != root(part)) groups.emplace_back(root(other), winding);
      }
      std::sort(groups.begin(), groups.end());
      for (std::size_t i = 0; i < groups.size();) {
        int sum = 0;
        const std::uint32_t other = groups[i].first;
        for (; i < groups.size() && groups[i].first == other; ++i) sum += groups[i].second;
        if (sum > 0) join(part, other);
      }
    }
  }

  const std::vector<CutPiece>& parts_;
  std::vector<std::uint32_t> here_;
  const CrossSection& section_;
  std::vector<std::uint32_t>& group_;
  Enclosures meshes_;
};

}  // namespace

std::vector<std::uint32_t> piece_groups(const std::vector<CutPiece>& parts, const std::vector<std::uint32_t>& cell,
                                        const CrossSection& section) {
  std::vector<std::uint32_t> group(parts.size()), order(parts.size());
  std::iota(group.begin(), group.end(), 0u);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return cell[a] < cell[b]; });
  for (std::size_t i = 0, end; i < order.size(); i = end) {
    for (end = i; end < order.size() && cell[order[end]] == cell[order[i]]; ++end) {
    }
    if (end - i > 1) Grouper(parts, {order.begin() + i, order.begin() + end}, section, group).run();
  }
  for (std::uint32_t& g : group) {
    while (group[g] != g) g = group[g];
  }
  return group;
}

}  // namespace pomona
