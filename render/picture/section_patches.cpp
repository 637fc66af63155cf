#include "render/picture/section_patches.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/section/guide_lattice.h"
#include "render/picture/paper.h"

namespace pomona {

namespace {

/// A corner of a patch, with the data for its colour.
struct PatchCorner {
  glm::dvec2 at{0};
  Color mean{0};
  DetailGuide guide{};
};

PatchCorner halfway(const PatchCorner& a, const PatchCorner& b) {
  PatchCorner middle{(a.at + b.at) * 0.5, (a.mean + b.mean) * 0.5f, {}};
  middle.guide.to_skin = (a.guide.to_skin + b.guide.to_skin) * 0.5f;
  middle.guide.layer = (a.guide.layer + b.guide.layer) * 0.5f;
  middle.guide.share = (a.guide.share + b.guide.share) * 0.5f;
  return middle;
}

std::uint8_t rounded(int channel) { return static_cast<std::uint8_t>(std::min((channel + 1) / 2 * 2, 255)); }

/// Halves the triangles of one section.
class PatchCutter {
 public:
  PatchCutter(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look, const Style& style,
              const PatchOptions& options)
      : section_(section),
        faces_(faces),
        look_(look),
        noise_(style.noise),
        paper_(style, options.width, options.height),
        options_(options) {}

  std::vector<SectionPatch> patches_of(std::size_t triangle) const {
    const PlacedFace& face = faces_[static_cast<std::size_t>(section_.cut[triangle])];
    std::vector<SectionPatch> patches;
    if (!face.shown) return patches;

    // Depth first, with a stack of triangles to visit.
    std::vector<std::array<PatchCorner, 3>> left{corners_of(triangle, face)};
    const std::int32_t part = section_.part[section_.triangle[triangle][0]];
    while (!left.empty()) {
      const std::array<PatchCorner, 3> corner = left.back();
      left.pop_back();
      const int longest = longest_edge(corner);
      const Range range = colors_of(corner, face);
      const glm::ivec3 spread = range.high - range.low;
      const double length = squared(corner, longest);
      const bool even = std::max({spread.x, spread.y, spread.z}) <= options_.tolerance;
      if (length <= options_.finest * options_.finest || (even && length <= options_.coarsest * options_.coarsest)) {
        const glm::ivec3 mean = (range.sum + 2) / 4;
        patches.push_back(
            {{corner[0].at, corner[1].at, corner[2].at}, {rounded(mean.x), rounded(mean.y), rounded(mean.z)}, part});
        continue;
      }
      const PatchCorner &a = corner[longest], &b = corner[(longest + 1) % 3], &c = corner[(longest + 2) % 3];
      const PatchCorner middle = halfway(a, b);
      left.push_back({a, middle, c});
      left.push_back({middle, b, c});
    }
    return patches;
  }

 private:
  std::array<PatchCorner, 3> corners_of(std::size_t triangle, const PlacedFace& face) const {
    std::array<PatchCorner, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = section_.triangle[triangle][i];
      corners[i] = {face.to_paper(section_.position[v]), section_.color[v], {}};
      if (!section_.guide.empty()) corners[i].guide = section_.guide[v];
    }
    return corners;
  }

  glm::ivec3 color_at(const PatchCorner& corner, const PlacedFace& face) const {
    LookPlace place{.position = face.to_fruit(corner.at), .footprint = 1.0 / face.scale};
    place.guide = guide_at(section_.guide_lattice.get(), place.position, corner.guide);
    const Color fresh = noise_ ? look_(corner.mean, place) : corner.mean;
    return to_srgb8(paper_.painted(fresh, static_cast<int>(corner.at.x), static_cast<int>(corner.at.y)));
  }

  /// The final colours of the corners and the centre.
  struct Range {
    glm::ivec3 low, high, sum;
  };
  Range colors_of(const std::array<PatchCorner, 3>& corner, const PlacedFace& face) const {
    const glm::ivec3 middle = color_at(halfway(halfway(corner[0], corner[1]), corner[2]), face);
    Range range{middle, middle, middle};
    for (const PatchCorner& each : corner) {
      const glm::ivec3 color = color_at(each, face);
      range = {glm::min(range.low, color), glm::max(range.high, color), range.sum + color};
    }
    return range;
  }

  static double squared(const std::array<PatchCorner, 3>& corner, int edge) {
    const glm::dvec2 d = corner[(edge + 1) % 3].at - corner[edge].at;
    return glm::dot(d, d);
  }
  static int longest_edge(const std::array<PatchCorner, 3>& corner) {
    int longest = 0;
    for (int edge = 1; edge < 3; ++edge) {
      if (squared(corner, edge) > squared(corner, longest)) longest = edge;
    }
    return longest;
  }

  const CrossSection& section_;
  const std::vector<PlacedFace>& faces_;
  const Look& look_;
  bool noise_;
  Paper paper_;
  PatchOptions options_;
};

}  // namespace

std::vector<SectionPatch> section_patches(const CrossSection& section, const std::vector<PlacedFace>& faces,
                                          const Look& look, const Style& style, const PatchOptions& options) {
  const PatchCutter cutter(section, faces, look, style, options);
  std::vector<std::vector<SectionPatch>> of_triangle(section.triangle.size());
  parallel_for(of_triangle.size(), options.threads, [&](std::size_t t) { of_triangle[t] = cutter.patches_of(t); });

  std::vector<SectionPatch> patches;
  for (const std::vector<SectionPatch>& own : of_triangle) patches.insert(patches.end(), own.begin(), own.end());
  return patches;
}

}  // namespace pomona
