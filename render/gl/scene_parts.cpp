#include "render/gl/scene_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/gl/scene_camera.h"

namespace pomona {

namespace {

/// A vertex on the picture: pixels, y down, and what grows with its nearness.
struct SeenVertex {
  glm::dvec2 at{0};
  double nearness = 0;  ///< 1 / distance; 0 = behind the eye
  std::int32_t part = -1;
};

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void mark(const std::array<SeenVertex, 3>& corner, PartMap& map, std::vector<double>& nearest) {
  const double whole = turn(corner[0].at, corner[1].at, corner[2].at);
  if (whole == 0 || std::min({corner[0].nearness, corner[1].nearness, corner[2].nearness}) <= 0) return;
  const auto [left, right] = std::minmax({corner[0].at.x, corner[1].at.x, corner[2].at.x});
  const auto [top, bottom] = std::minmax({corner[0].at.y, corner[1].at.y, corner[2].at.y});
  const auto pixel = [](double v, int limit) { return static_cast<int>(std::clamp(std::floor(v), 0.0, limit - 1.0)); };
  for (int y = pixel(top, map.height); y <= pixel(bottom, map.height); ++y) {
    for (int x = pixel(left, map.width); x <= pixel(right, map.width); ++x) {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const std::array<double, 3> share{turn(corner[1].at, corner[2].at, p) / whole,
                                        turn(corner[2].at, corner[0].at, p) / whole,
                                        turn(corner[0].at, corner[1].at, p) / whole};
      if (std::min({share[0], share[1], share[2]}) < 0) continue;
      double near = 0;
      for (std::size_t i = 0; i < 3; ++i) near += share[i] * corner[i].nearness;
      const std::size_t at = static_cast<std::size_t>(y) * map.width + x;
      if (near <= nearest[at]) continue;
      nearest[at] = near;
      map.part[at] =
          corner[static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin())].part;
    }
  }
}

double slope_of(const View& view) { return std::tan(0.5 * view.vertical_field); }

}  // namespace

PartMap scene_parts(const Scene& scene, int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  PartMap map{width, height, std::vector<std::int32_t>(pixels, -1), {}};
  if (!scene.solids.empty()) map.names = scene.solids[0].part_names;
  std::vector<double> nearest(pixels, 0);
  const double scale = 0.5 * height / slope_of(scene.view);
  const glm::dmat4 view(camera_of(scene, ball_around(scene), static_cast<double>(width) / height).view);

  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[instance.solid];
    const glm::dmat4 to_camera = view * glm::dmat4(matrix_of(instance.pose));
    std::vector<SeenVertex> seen(solid.position.size());
    for (std::size_t v = 0; v < seen.size(); ++v) {
      const glm::dvec4 p = to_camera * glm::dvec4(glm::dvec3(solid.position[v]), 1);
      if (p.z >= -1e-6) continue;
      const bool named = solid.part[v] >= 0 && solid.part[v] < static_cast<std::int32_t>(map.names.size());
      seen[v] = {
          {0.5 * width - p.x / p.z * scale, 0.5 * height + p.y / p.z * scale}, -1 / p.z, named ? solid.part[v] : -1};
    }
    for (const glm::uvec3& t : solid.triangle) mark({seen[t.x], seen[t.y], seen[t.z]}, map, nearest);
  }
  return map;
}

View view_within(const View& view, const glm::dvec2& picture, const glm::dvec2& low, const glm::dvec2& high) {
  View wider = view;
  wider.vertical_field = 2 * std::atan(slope_of(view) * picture.y / std::max(high.y - low.y, 1.0));

  // Step aside, so that the target comes to lie in the middle of the box.
  const glm::dvec3 forward = glm::normalize(view.target - view.eye);
  const glm::dvec3 wish = std::fabs(forward.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, wish)), up = glm::cross(right, forward);
  const glm::dvec2 off = (0.5 * (low + high) - 0.5 * picture) / pixels_per_metre(wider, picture.y);
  wider.eye += up * off.y - right * off.x;
  wider.target += up * off.y - right * off.x;
  return wider;
}

double pixels_per_metre(const View& view, double picture_height) {
  return 0.5 * picture_height / slope_of(view) / glm::length(view.target - view.eye);
}

}  // namespace pomona
