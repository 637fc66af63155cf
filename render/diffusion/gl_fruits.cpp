#include "render/diffusion/gl_fruits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

namespace {

template <typename Value>
GlBuffer joined(const CurrentGl& gl, std::span<const RaySurfaces> fruits, std::vector<Value> RaySurfaces::*array) {
  std::vector<Value> all;
  for (const RaySurfaces& fruit : fruits) all.insert(all.end(), (fruit.*array).begin(), (fruit.*array).end());
  return {gl, GL_SHADER_STORAGE_BUFFER, all};
}

/// The limits of the buffers that may be the largest.
struct Bytes {
  std::size_t nodes = 0, triangles = 0, colors = 0;

  void add(const RaySurfaces& fruit) {
    nodes += fruit.node.size() * sizeof(RayNode);
    triangles += fruit.triangle.size() * sizeof(RayTriangle);
    colors += fruit.color.size() * sizeof(glm::vec4);
  }
  std::size_t max() const { return std::max({nodes, triangles, colors}); }
};

}  // namespace

GlFruits uploaded(const CurrentGl& gl, std::span<const RaySurfaces> fruits) {
  std::vector<FruitPlace> places;
  FruitPlace next;
  for (const RaySurfaces& fruit : fruits) {
    places.push_back(next);
    next.node += static_cast<std::uint32_t>(fruit.node.size());
    next.triangle += static_cast<std::uint32_t>(fruit.triangle.size());
    next.vertex += static_cast<std::uint32_t>(fruit.color.size() / 2);
  }
  GlFruits result{std::move(places), joined(gl, fruits, &RaySurfaces::node), joined(gl, fruits, &RaySurfaces::triangle),
                  joined(gl, fruits, &RaySurfaces::side), joined(gl, fruits, &RaySurfaces::color)};
  gl.check("uploading surfaces");
  return result;
}

std::vector<std::size_t> runs_that_fit(std::span<const RaySurfaces> fruits, std::size_t max_bytes) {
  std::vector<std::size_t> borders{0};
  Bytes run;
  for (std::size_t i = 0; i < fruits.size(); ++i) {
    Bytes alone;
    alone.add(fruits[i]);
    if (alone.max() > max_bytes) {
      throw Error(ExitStatus::helper_missing,
                  "surfaces of " + std::to_string(fruits[i].triangle.size()) + " triangles need storage buffers of " +
                      std::to_string((alone.max() >> 20) + 1) + " MiB; this OpenGL has " +
                      std::to_string(max_bytes >> 20) + " MiB",
                  "use --diffuser cpu");
    }
    run.add(fruits[i]);
    if (run.max() <= max_bytes) continue;
    borders.push_back(i);
    run = alone;
  }
  borders.push_back(fruits.size());
  return borders;
}

}  // namespace pomona
