#include "render/gl/placed_solids.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/scene/placed_boxes.h"
#include "render/gl/scene_camera.h"

namespace pomona {

namespace {

std::vector<std::size_t> from_the_eye_outwards(const Scene& scene) {
  std::vector<double> away;
  for (const Instance& instance : scene.instances) {
    const glm::dvec3 d = instance.pose.translation - scene.view.eye;
    away.push_back(glm::dot(d, d));
  }
  std::vector<std::size_t> order(scene.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return away[a] < away[b]; });
  return order;
}

/// Waits now and then until OpenGL has drawn. Software OpenGL keeps the triangles of all queued draws, nearly a
/// kilobyte each: hundreds of megabytes if drawing is slower than queueing.
class Pace {
 public:
  explicit Pace(const CurrentGl& gl) : gl_(gl) {}
  void handed_over(GLsizei indices) {
    constexpr GLsizei max = 3 * 50'000;
    waiting_ += indices;
    if (waiting_ < max) return;
    gl_->Finish();
    waiting_ = 0;
  }

 private:
  const CurrentGl& gl_;
  GLsizei waiting_ = 0;
};

Drawn how_drawn(const Solid& solid) { return solid.opacity < 1 ? Drawn::see_through : Drawn::opaque; }

}  // namespace

PlacedSolids::PlacedSolids(const CurrentGl& gl, const Scene& scene, const Style& style)
    : gl_(gl), scene_(scene), uploaded_(uploaded(gl, scene, style)), nearest_first_(from_the_eye_outwards(scene)) {}

bool PlacedSolids::any(Drawn which) const {
  return std::any_of(scene_.instances.begin(), scene_.instances.end(),
                     [&](const Instance& instance) { return how_drawn(scene_.solids[instance.solid]) == which; });
}

void PlacedSolids::draw(const Program& program, Drawn which) const {
  uploaded_.solids.bind();
  Pace pace(gl_);
  for (const std::size_t i : nearest_first_) {
    const Instance& instance = scene_.instances[i];
    const Solid& solid = scene_.solids[instance.solid];
    if (how_drawn(solid) != which) continue;
    const UploadedSolids::Part& part = uploaded_.parts[instance.solid];
    (solid.closed ? gl_->Enable : gl_->Disable)(GL_CULL_FACE);
    program.set("placement", matrix_of(instance.pose));
    program.set("opacity", solid.opacity);
    program.set("instance_id", static_cast<unsigned>((i + 1) & 0x7ffff) << 12);
    program.set("first_triangle", part.first_triangle);
    gl_->DrawElementsBaseVertex(GL_TRIANGLES, part.indices, GL_UNSIGNED_INT,
                                reinterpret_cast<const void*>(part.first_index * sizeof(std::uint32_t)),
                                part.first_vertex);
    pace.handed_over(part.indices);
  }
  gl_->Disable(GL_CULL_FACE);
}

bool PlacedSolids::any_hairs() const {
  return std::any_of(uploaded_.parts.begin(), uploaded_.parts.end(),
                     [](const UploadedSolids::Part& part) { return part.hair_vertices > 0; });
}

void PlacedSolids::draw_hairs(const Program& program) const {
  uploaded_.hairs.bind();
  for (const Instance& instance : scene_.instances) {
    const UploadedSolids::Part& part = uploaded_.parts[instance.solid];
    if (part.hair_vertices == 0) continue;
    program.set("placement", matrix_of(instance.pose));
    gl_->DrawArrays(GL_LINES, part.first_hair_vertex, part.hair_vertices);
  }
}

}  // namespace pomona
