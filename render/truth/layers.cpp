#include "render/truth/layers.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/cross.h"
#include "render/strokes/covered_pixels.h"
#include "render/strokes/identity_buffer.h"

namespace pomona {

namespace {

/// Barycentric weights, in space, of the place seen at a pixel: sum 1, none below 0.
std::array<double, 3> shares_at(const PictureTriangle& triangle, const glm::dvec2& place) {
  std::array<double, 3> share{};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const auto &a = triangle.corner[(i + 1) % 3], &b = triangle.corner[(i + 2) % 3];
    const double on_picture = cross(glm::dvec2(a) - place, glm::dvec2(b) - place) * (triangle.area > 0 ? -1 : 1);
    share[i] = std::max(0.0, on_picture) * triangle.corner[i].z;  // nearer corners cover more of the picture
    sum += share[i];
  }
  for (double& s : share) s = sum > 0 ? s / sum : 1.0 / 3;
  return share;
}

class LayerFiller {
 public:
  LayerFiller(const Scene& scene, const TruthNaming& names, const Lens& lens, const IdentityBuffer& foremost)
      : scene_(scene), names_(names), lens_(lens), foremost_(foremost) {
    for (const Instance& instance : scene.instances) turn_.push_back(glm::mat3_cast(instance.pose.rotation));
    const std::size_t pixels = foremost.instance.size();
    layers_.width = foremost.width;
    layers_.height = foremost.height;
    for (auto* numbers : {&layers_.instance, &layers_.fruit, &layers_.part, &layers_.organ}) numbers->assign(pixels, 0);
    layers_.depth.assign(pixels, 0);
    layers_.normal.assign(pixels, glm::vec3(0));
    layers_.section.assign(pixels, 0);
  }

  TruthLayers fill(Threads threads) {
    parallel_for(static_cast<std::size_t>(layers_.height), threads, [&](std::size_t y) {
      for (int x = 0; x < layers_.width; ++x) fill_pixel(x, static_cast<int>(y));
    });
    return std::move(layers_);
  }

 private:
  void fill_pixel(int x, int y) {
    const std::size_t pixel = layers_.pixel(x, y);
    if (foremost_.instance[pixel] == 0) return;
    const std::size_t i = foremost_.instance[pixel] - 1, number = scene_.instances[i].solid;
    const Solid& solid = scene_.solids[number];
    const std::uint32_t t = foremost_.triangle[pixel];
    layers_.instance[pixel] = static_cast<std::uint16_t>(i + 1);
    layers_.fruit[pixel] = names_.fruit_of_solid[number];
    if (t < solid.mesh.instance.size()) layers_.organ[pixel] = static_cast<std::uint16_t>(solid.mesh.instance[t]);
    layers_.depth[pixel] = 1 / foremost_.nearness[pixel];
    layers_.section[pixel] = t < solid.mesh.cut_face.size() && solid.mesh.cut_face[t] >= 0 ? 1 : 0;

    const PictureTriangle triangle = seen_triangle(i, t);
    const std::array<double, 3> share = shares_at(triangle, {x + 0.5, y + 0.5});
    const auto largest = static_cast<int>(std::max_element(share.begin(), share.end()) - share.begin());
    const std::int32_t part = solid.mesh.part[solid.mesh.triangle[t][largest]];
    const std::vector<std::uint16_t>& parts = names_.parts_of_solid[number];
    if (part >= 0 && static_cast<std::size_t>(part) < parts.size()) layers_.part[pixel] = parts[part];
    layers_.normal[pixel] = normal_at(solid, t, share, turn_[i], triangle.area > 0);
  }

  /// Projects the triangle again as the identity buffer did: all vertices of a large heap would take a gigabyte.
  PictureTriangle seen_triangle(std::size_t instance, std::uint32_t t) const {
    const Instance& placed = scene_.instances[instance];
    const Solid& solid = scene_.solids[static_cast<std::size_t>(placed.solid)];
    std::array<glm::dvec3, 3> corner{};
    for (int i = 0; i < 3; ++i)
      corner[i] = lens_.seen(turn_[instance] * glm::dvec3(solid.mesh.position[solid.mesh.triangle[t][i]]) +
                             placed.pose.translation);
    return picture_triangle(corner);
  }

  static glm::vec3 normal_at(const Solid& solid, std::uint32_t t, const std::array<double, 3>& share,
                             const glm::dmat3& turn, bool faces_eye) {
    glm::dvec3 sum(0);
    for (int i = 0; i < 3; ++i) sum += share[i] * glm::dvec3(solid.mesh.normal[solid.mesh.triangle[t][i]]);
    const double length = glm::length(sum);
    if (!(length > 0)) return glm::vec3(0);
    return glm::vec3(glm::normalize(turn * sum) * (faces_eye ? 1.0 : -1.0));
  }

  const Scene& scene_;
  const TruthNaming& names_;
  const Lens& lens_;
  std::vector<glm::dmat3> turn_;  // rotation of each instance
  const IdentityBuffer& foremost_;
  TruthLayers layers_;
};

}  // namespace

TruthLayers truth_layers(const Scene& scene, const TruthNaming& names, int width, int height, Threads threads) {
  const Lens lens(scene.view, width, height);
  const IdentityBuffer foremost = identity_buffer(scene, lens, threads);
  return LayerFiller(scene, names, lens, foremost).fill(threads);
}

}  // namespace pomona
