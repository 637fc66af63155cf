#include "render/strokes/lens.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

Lens::Lens(const View& view, int width, int height)
    : frame_(view_frame(view)),
      eye_(view.eye),
      pixels_(0.5 * height * reproducible::cos(0.5 * view.vertical_field) /
              reproducible::sin(0.5 * view.vertical_field)),
      nearest_(1e-3 * frame_.distance),
      width_(width),
      height_(height) {}

glm::dvec3 Lens::seen(const glm::dvec3& point) const {
  const glm::dvec3 d = point - eye_;
  const double distance = -glm::dot(d, frame_.back);
  if (!(distance > nearest_)) return {0, 0, 0};
  const double scale = pixels_ / distance;
  return {0.5 * width_ + glm::dot(d, frame_.right) * scale, 0.5 * height_ - glm::dot(d, frame_.up) * scale, distance};
}

glm::dvec3 Lens::in_scene(const glm::dvec2& pixel, double distance) const {
  const glm::dvec2 q = (pixel - 0.5 * glm::dvec2(width_, height_)) * (distance / pixels_);
  return eye_ + frame_.right * q.x - frame_.up * q.y - frame_.back * distance;
}

glm::dvec2 Lens::seen_direction(const glm::dvec3& point, const glm::dvec3& direction) const {
  // The change of x / z and y / z along the direction.
  const glm::dvec3 d = point - eye_;
  const double z = -glm::dot(d, frame_.back), dz = -glm::dot(direction, frame_.back);
  const glm::dvec2 moved(glm::dot(direction, frame_.right) * z - glm::dot(d, frame_.right) * dz,
                         glm::dot(d, frame_.up) * dz - glm::dot(direction, frame_.up) * z);
  const double size = std::sqrt(glm::dot(moved, moved));
  return size > 1e-12 * z ? moved / size : glm::dvec2(0);
}

}  // namespace pomona
