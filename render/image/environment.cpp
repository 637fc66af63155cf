#include "render/image/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/error.h"
#include "generator/base/luminance.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/image/hdr.h"
#include "render/image/linear_pixels.h"
#include "render/image/png.h"

namespace pomona {

namespace {

// White paper under the usual light of pictures (shaders/lit.glsl) gets this much from the lamp, and from all sides.
constexpr double usual_lamp = 0.7, usual_ambient = 0.5;

/// A direction of the sky, and the solid angle for which it stands.
struct SkyPlace {
  Color color{0};
  double luminance = 0;
  glm::dvec3 direction{0, 1, 0};
  double solid_angle = 0;
};

/// The picture in means of squares, so that no row is longer than light needs.
LinearImage coarse(const LinearImage& picture) {
  constexpr int enough = 1024;
  const int side = picture.width / enough;
  if (side < 2) return picture;
  LinearImage means{picture.width / side, picture.height / side, {}};
  for (int y = 0; y < means.height; ++y) {
    for (int x = 0; x < means.width; ++x) {
      Color sum(0);
      for (int k = 0; k < side * side; ++k)
        sum += picture.pixels[static_cast<std::size_t>(y * side + k / side) * picture.width + x * side + k % side];
      means.pixels.push_back(sum / static_cast<float>(side * side));
    }
  }
  return means;
}

/// All pixels above the horizon.
std::vector<SkyPlace> sky_of(const LinearImage& picture) {
  std::vector<glm::dvec2> around;  // sine and cosine of each column's azimuth
  for (int x = 0; x < picture.width; ++x) {
    const double azimuth = -2 * pi * (x + 0.5) / picture.width;
    around.emplace_back(reproducible::sin(azimuth), reproducible::cos(azimuth));
  }
  std::vector<SkyPlace> sky;
  const int rows = picture.height / 2;
  for (int y = 0; y < rows; ++y) {
    const double elevation = pi / 2 - pi * (y + 0.5) / picture.height;
    const double level = reproducible::cos(elevation), up = reproducible::sin(elevation);
    const double solid_angle = 2 * pi / picture.width * pi / picture.height * level;
    for (int x = 0; x < picture.width; ++x) {
      const Color& color = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
      const glm::dvec2& turn = around[static_cast<std::size_t>(x)];
      sky.push_back({color, luminance(color), {level * turn.x, up, level * turn.y}, solid_angle});
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

/// What a sky gives to a table beneath it.
struct SkyLight {
  glm::dvec3 lamp{0};         ///< towards the lamp, as long as what comes from there: luminance times solid angle
  double lamp_sum = 0;        ///< the same if it all came from one direction
  double from_all_sides = 0;  ///< on the table, of what is no lamp: luminance times solid angle
  double on_table = 0;        ///< on the table, of all
  glm::dvec3 color{0};        ///< the same by channels
};

/// The lamp is what is more than twice as bright as half of the sky.
SkyLight sky_light(const std::vector<SkyPlace>& sky) {
  const double bright = std::max(2 * median_luminance(sky), 1e-4);
  SkyLight light;
  for (const SkyPlace& place : sky) {
    const double beyond = std::max(0.0, place.luminance - bright);
    light.lamp += beyond * place.solid_angle * place.direction;
    light.lamp_sum += beyond * place.solid_angle;
    const double received = place.solid_angle * place.direction.y;
    light.from_all_sides += (place.luminance - beyond) * received;
    light.on_table += place.luminance * received;
    light.color += received * glm::dvec3(place.color);
  }
  return light;
}

/// With the lamp where the sky's is, and as wide; a sky without one is a lamp of its own.
EnvironmentLight with_lamp(EnvironmentLight light, const SkyLight& sky) {
  if (!(sky.lamp_sum > 0)) {
    light.elevation = pi / 2;
    light.softness = 1;
    return light;
  }
  const double directed = glm::length(sky.lamp);
  const glm::dvec3 towards = sky.lamp / directed;
  light.azimuth = reproducible::atan2(towards.x, towards.z);
  light.elevation =
      std::max(reproducible::atan2(towards.y, std::sqrt(std::max(0.0, 1 - towards.y * towards.y))), 5 * pi / 180);
  light.softness = std::clamp(0.05 + 2 * (1 - directed / sky.lamp_sum), 0.0, 1.0);
  return light;
}

/// Facing the lamp, as much from it as the sky says beside the light from all sides; both together as usual.
EnvironmentLight with_shares(EnvironmentLight light, const SkyLight& sky) {
  const double ratio = sky.from_all_sides > 0 ? glm::length(sky.lamp) / sky.from_all_sides : 0;
  const double all = usual_lamp + usual_ambient, lamp_share = ratio / (1 + ratio);
  light.strength = all * lamp_share / usual_lamp;
  light.ambient = all * (1 - lamp_share) / usual_ambient;
  return light;
}

/// The direction in which a camera sees the middle of a pixel. \param half tangent of half the vertical field
glm::dvec3 direction_seen(const CameraAxes& camera, double half, const glm::ivec2& pixel, const glm::ivec2& size) {
  const double across = half * (2 * (pixel.x + 0.5) - size.x) / size.y;
  const double upwards = half * (size.y - 2 * (pixel.y + 0.5)) / size.y;
  return glm::normalize(across * camera.right + upwards * camera.up - camera.back);
}

/// Colours of an environment in between its pixels.
class Surroundings {
 public:
  explicit Surroundings(const LinearImage& picture)
      : width_(picture.width), height_(picture.height), pixels_(picture.pixels) {}

  Color towards(const glm::dvec3& d) const {
    const double azimuth = reproducible::atan2(d.x, d.z);
    const double elevation = reproducible::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z));
    const double u = -azimuth / (2 * pi) * width_ - 0.5;
    const double v = (pi / 2 - elevation) / pi * height_ - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const double s = u - left, t = v - top;
    return Color((pixel(left, top) * (1 - s) + pixel(left + 1, top) * s) * (1 - t) +
                 (pixel(left, top + 1) * (1 - s) + pixel(left + 1, top + 1) * s) * t);
  }

 private:
  /// Columns go around, rows end at the poles.
  glm::dvec3 pixel(int x, int y) const {
    const int around = ((x % width_) + width_) % width_;
    return glm::dvec3(pixels_[static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * width_ + around]);
  }

  int width_, height_;
  const std::vector<Color>& pixels_;
};

void check_shape(int width, int height, const std::string& name) {
  if (height >= 2 && width == 2 * height) return;
  throw Error(ExitStatus::bad_data, name + ": is no picture of all directions",
              "environments are equirectangular: twice as wide as high");
}

/// As bright as if white paper that faces upwards in its light were white.
LinearImage exposed(LinearImage picture) {
  const double on_table = sky_light(sky_of(coarse(picture))).on_table;
  if (!(on_table > 0)) return picture;
  for (Color& pixel : picture.pixels) pixel *= static_cast<float>(pi / on_table);
  return picture;
}

}  // namespace

LinearImage read_environment(const std::string& bytes, const std::string& name) {
  if (is_hdr(bytes)) {
    LinearImage picture = read_hdr(bytes, name);
    check_shape(picture.width, picture.height, name);
    return exposed(std::move(picture));
  }
  const Image picture = read_png(bytes, name);
  check_shape(picture.width, picture.height, name);
  return {picture.width, picture.height, linear_pixels(picture)};
}

EnvironmentLight light_of(const LinearImage& picture) {
  const SkyLight sky = sky_light(sky_of(coarse(picture)));
  EnvironmentLight light;
  if (sky.on_table > 0) light.tint = Color(sky.color / sky.on_table);
  return with_shares(with_lamp(light, sky), sky);
}

Image seen_around(const LinearImage& picture, const CameraAxes& camera, double vertical_field, int width, int height) {
  const double half = reproducible::sin(0.5 * vertical_field) / reproducible::cos(0.5 * vertical_field);
  const Surroundings around(picture);
  std::vector<Color> seen;
  seen.reserve(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      seen.push_back(around.towards(direction_seen(camera, half, {x, y}, {width, height})));
  return image_of(seen, width, height);
}

}  // namespace pomona
