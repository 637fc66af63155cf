#include "render/export/pov_ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "generator/base/number_text.h"
#include "render/export/pov_text.h"
#include "render/strokes/lens.h"

namespace pomona::pov {

namespace {

constexpr double steps_a_unit = 10000;  // steps per unit; coordinates are whole numbers of steps

/// Red, green, blue, and opacity in sixteenths.
using Ink = std::array<float, 4>;

Ink ink_of(const SceneStroke& stroke) {
  const Color& color = stroke.color;
  double opacity = 0;
  for (const StrokePoint& point : stroke.points) opacity += point.opacity;
  opacity /= static_cast<double>(stroke.points.size());
  return {color.r, color.g, color.b, static_cast<float>(std::floor(16 * std::clamp(opacity, 0.0, 1.0) + 0.5) / 16)};
}

struct Ribbons {
  std::string places, faces;
  std::int64_t place_count = 0, face_count = 0;
};

void append_place(const glm::dvec3& p, double unit, std::string& text) {
  const glm::dvec3 q = glm::floor(p * (steps_a_unit / unit) + 0.5);
  append_integers(text, static_cast<std::int64_t>(q.x), static_cast<std::int64_t>(q.y), static_cast<std::int64_t>(q.z));
  text += ',';
}

void append_stroke(const SceneStroke& stroke, const Lens& lens, double unit, Ribbons& ribbons) {
  const std::vector<StrokePoint>& points = stroke.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 d = points[std::min(i + 1, points.size() - 1)].at - points[i > 0 ? i - 1 : 0].at;
    const double size = glm::length(d);
    const glm::dvec2 across = size > 0 ? glm::dvec2(-d.y, d.x) * (points[i].radius / size) : glm::dvec2(0);

    // A ribbon steps forward before it meets what is nearer.
    double distance = stroke.distance[i];
    for (std::size_t k = i > 3 ? i - 3 : 0; k < std::min(i + 4, points.size()); ++k) {
      distance = std::min(distance, stroke.distance[k]);
    }
    append_place(lens.in_scene(points[i].at + across, distance), unit, ribbons.places);
    append_place(lens.in_scene(points[i].at - across, distance), unit, ribbons.places);
    if (i > 0) {
      const std::int64_t n = ribbons.place_count;
      append_integers(ribbons.faces, n - 2, n - 1, n);
      ribbons.faces += ',';
      append_integers(ribbons.faces, n - 1, n + 1, n);
      ribbons.faces += i % 8 == 0 ? ",\n" : ",";
      ribbons.face_count += 2;
    }
    ribbons.place_count += 2;
  }
}

}  // namespace

std::string ink_text(const Scene& scene, const SceneInk& ink, int unit_exponent) {
  const Lens lens(scene.view, ink.width, ink.height);
  std::map<Ink, Ribbons> by_ink;
  for (const SceneStroke& stroke : ink.strokes) {
    if (stroke.points.size() < 2) continue;
    append_stroke(stroke, lens, power_of_ten(unit_exponent), by_ink[ink_of(stroke)]);
  }

  std::string text = "#declare Ink = union {\n";
  for (auto& [color, ribbons] : by_ink) {
    ribbons.places.pop_back();
    text += "mesh2 {\nvertex_vectors { " + std::to_string(ribbons.place_count) + ",\n" + ribbons.places + " }\n";
    text += "face_indices { " + std::to_string(ribbons.face_count) + ",\n";
    ribbons.faces.erase(ribbons.faces.find_last_of(','));
    text += ribbons.faces + " }\ntexture { pigment { rgbt <" + number_text(double{color[0]}) + ", " +
            number_text(double{color[1]}) + ", " + number_text(double{color[2]}) + ", " +
            number_text(1 - double{color[3]}) + "> } finish { ambient 0 diffuse 0 emission 1 } }\n}\n";
  }
  return text + "scale " + number_text(1 / steps_a_unit) + " no_shadow no_reflection no_radiosity }\n";
}

}  // namespace pomona::pov
