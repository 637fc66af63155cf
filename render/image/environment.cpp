#include "render/image/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/image/linear_pixels.h"

namespace pomona {

namespace {

// White paper under the usual light of pictures (shaders/lit.glsl) gets this much from the lamp, and from all sides.
constexpr double usual_lamp = 0.7, usual_ambient = 0.5;

double luminance_of(const Color& color) {
  return 0.2126 * static_cast<double>(color.r) + 0.7152 * static_cast<double>(color.g) +
         0.0722 * static_cast<double>(color.b);
}

/// A direction of the sky, and the solid angle for which it stands.
struct SkyPlace {
  Color color{0};
  double luminance = 0;
  glm::dvec3 direction{0, 1, 0};
  double solid_angle = 0;
};

/// All pixels above the horizon.
std::vector<SkyPlace> sky_of(const Image& picture) {
  std::vector<glm::dvec2> around;  // sine and cosine of each column's azimuth
  for (int x = 0; x < picture.width; ++x) {
    const double azimuth = -2 * pi * (x + 0.5) / picture.width;
    around.emplace_back(reproducible::sin(azimuth), reproducible::cos(azimuth));
  }
  const std::vector<Color> pixels = linear_pixels(picture);
  std::vector<SkyPlace> sky;
  const int rows = picture.height / 2;
  for (int y = 0; y < rows; ++y) {
    const double elevation = pi / 2 - pi * (y + 0.5) / picture.height;
    const double level = reproducible::cos(elevation), up = reproducible::sin(elevation);
    const double solid_angle = 2 * pi / picture.width * pi / picture.height * level;
    for (int x = 0; x < picture.width; ++x) {
      const Color& color = pixels[static_cast<std::size_t>(y) * picture.width + x];
      const glm::dvec2& turn = around[static_cast<std::size_t>(x)];
      sky.push_back({color, luminance_of(color), {level * turn.x, up, level * turn.y}, solid_angle});
    }
  }
  return sky;
}

/// The luminance that half of the sky exceeds.
double median_luminance(const std::vector<SkyPlace>& sky) {
  std::vector<std::pair<double, double>> sorted;
  double all = 0;
  for (const SkyPlace& place : sky) sorted.emplace_back(place.luminance, place.solid_angle), all += place.solid_angle;
  std::sort(sorted.begin(), sorted.end());
  double below = 0;
  for (const auto& [luminance, solid_angle] : sorted)
    if ((below += solid_angle) >= 0.5 * all) return luminance;
  return 0;
}

}  // namespace

void check_environment(const Image& picture, const std::string& name) {
  if (picture.height >= 2 && picture.width == 2 * picture.height) return;
  throw Error(ExitStatus::bad_data, name + ": is no picture of all directions",
              "environments are equirectangular: twice as wide as high");
}

EnvironmentLight light_of(const Image& picture) {
  const std::vector<SkyPlace> sky = sky_of(picture);

  // The lamp is what is more than twice as bright as half of the sky.
  const double bright = std::max(2 * median_luminance(sky), 1e-4);
  glm::dvec3 lamp(0), color(0);
  double lamp_sum = 0, from_all_sides = 0, on_table = 0;
  for (const SkyPlace& place : sky) {
    const double beyond = std::max(0.0, place.luminance - bright);
    lamp += beyond * place.solid_angle * place.direction;
    lamp_sum += beyond * place.solid_angle;
    const double received = place.solid_angle * place.direction.y;
    from_all_sides += (place.luminance - beyond) * received;
    on_table += place.luminance * received;
    color += received * glm::dvec3(place.color);
  }
  const double directed = glm::length(lamp);
  EnvironmentLight light;
  if (on_table > 0) light.tint = Color(color / on_table);
  if (lamp_sum > 0) {
    const glm::dvec3 towards = lamp / directed;
    light.azimuth = reproducible::atan2(towards.x, towards.z);
    light.elevation =
        std::max(reproducible::atan2(towards.y, std::sqrt(std::max(0.0, 1 - towards.y * towards.y))), 5 * pi / 180);
    light.softness = std::clamp(0.05 + 2 * (1 - directed / lamp_sum), 0.0, 1.0);
  } else {
    light.elevation = pi / 2;
    light.softness = 1;
  }

  // Facing the lamp, as much from it as the picture says beside the light from all sides; both together as usual.
  const double ratio = from_all_sides > 0 ? directed / from_all_sides : 0;
  const double all = usual_lamp + usual_ambient, lamp_share = ratio / (1 + ratio);
  light.strength = all * lamp_share / usual_lamp;
  light.ambient = all * (1 - lamp_share) / usual_ambient;
  return light;
}

Image seen_around(const Image& picture, const CameraAxes& camera, double vertical_field, int width, int height) {
  const double half = reproducible::sin(0.5 * vertical_field) / reproducible::cos(0.5 * vertical_field);
  const std::vector<Color> pixels = linear_pixels(picture);
  const auto pixel = [&](int x, int y) {
    const int around = ((x % picture.width) + picture.width) % picture.width;
    return glm::dvec3(pixels[static_cast<std::size_t>(std::clamp(y, 0, picture.height - 1)) * picture.width + around]);
  };
  std::vector<Color> seen;
  seen.reserve(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double across = half * (2 * (x + 0.5) - width) / height, upwards = half * (height - 2 * (y + 0.5)) / height;
      const glm::dvec3 d = glm::normalize(across * camera.right + upwards * camera.up - camera.back);
      const double azimuth = reproducible::atan2(d.x, d.z);
      const double elevation = reproducible::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z));
      const double u = -azimuth / (2 * pi) * picture.width - 0.5;
      const double v = (pi / 2 - elevation) / pi * picture.height - 0.5;
      const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
      const double s = u - left, t = v - top;
      seen.emplace_back((pixel(left, top) * (1 - s) + pixel(left + 1, top) * s) * (1 - t) +
                        (pixel(left, top + 1) * (1 - s) + pixel(left + 1, top + 1) * s) * t);
    }
  }
  return image_of(seen, width, height);
}

}  // namespace pomona
