#include "render/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "render/compare/flip_kernels.h"

namespace pomona {

namespace {

// XYZ of linear sRGB, by columns. The rows' sums are the white that FLIP's published figures were made with,
// (0.950428545, 1, 1.088900371); it differs in the fifth digit from the one of the standard.
const glm::dmat3 xyz_from_linear(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0,
                                 8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                                 4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);
const glm::dvec3 white = xyz_from_linear * glm::dvec3(1);
const glm::dmat3 linear_from_xyz = glm::inverse(xyz_from_linear);

/// CIELAB's cube root, with its straight piece near black.
double lab_curve(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta * delta * delta ? reproducible::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
}

/// Linear sRGB, 0..1 a channel, as Y, Cx, Cz: CIELAB without its cube root, so that filters may sum it.
glm::dvec3 opponent_from_linear(const glm::dvec3& rgb) {
  const glm::dvec3 share = xyz_from_linear * rgb / white;
  return {116 * share.y - 16, 500 * (share.x - share.y), 200 * (share.y - share.z)};
}

glm::dvec3 linear_from_opponent(const glm::dvec3& opponent) {
  const double y = (opponent.x + 16) / 116;
  return linear_from_xyz * (glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * white);
}

/// Linear sRGB as CIELAB, with a and b scaled by lightness: colourfulness fades in the dark [Hunt 1952].
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& rgb) {
  const glm::dvec3 share = xyz_from_linear * rgb / white;
  const glm::dvec3 root(lab_curve(share.x), lab_curve(share.y), lab_curve(share.z));
  const double lightness = 116 * root.y - 16;
  return {lightness, 0.01 * lightness * 500 * (root.x - root.y), 0.01 * lightness * 200 * (root.y - root.z)};
}

/// Distance of two such colours that is also right for large ones: |L| + |(a, b)| [Abasi et al. 2020].
double hyab(const glm::dvec3& first, const glm::dvec3& second) {
  const glm::dvec3 d = first - second;
  return std::fabs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

/// The luminance of a linear colour, 0..1, in which edges and points are found.
double luminance_of_linear(const glm::dvec3& rgb) { return (opponent_from_linear(rgb).x + 16) / 116; }

/// The number of rows in a band: memory does not grow with the picture's height.
constexpr int band_rows = 64;

/// One number per pixel. A band's planes also hold rows above and below it, as far as filters reach.
struct PicturePlane {
  int width = 0;
  int height = 0;
  std::vector<double> value;
  PicturePlane(int w, int h) : width(w), height(h), value(static_cast<std::size_t>(w) * h) {}
  double& at(int x, int y) { return value[static_cast<std::size_t>(y) * width + x]; }
  double at(int x, int y) const { return value[static_cast<std::size_t>(y) * width + x]; }
};

PicturePlane filtered_along_rows(const PicturePlane& plane, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  PicturePlane result(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0;
      for (int i = -radius; i <= radius; ++i) {
        sum += kernel[static_cast<std::size_t>(i + radius)] * plane.at(std::clamp(x + i, 0, plane.width - 1), y);
      }
      result.at(x, y) = sum;
    }
  }
  return result;
}

/// The band's own rows; the plane holds `reach` more above and below.
PicturePlane filtered_along_columns(const PicturePlane& plane, const Kernel& kernel, int reach) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  PicturePlane result(plane.width, plane.height - 2 * reach);
  for (int y = 0; y < result.height; ++y) {
    for (int i = -radius; i <= radius; ++i) {
      const double weight = kernel[static_cast<std::size_t>(i + radius)];
      for (int x = 0; x < plane.width; ++x) result.at(x, y) += weight * plane.at(x, y + reach + i);
    }
  }
  return result;
}

PicturePlane filtered(const PicturePlane& plane, const Kernel& across, const Kernel& along, int reach) {
  return filtered_along_columns(filtered_along_rows(plane, across), along, reach);
}

struct Filters {
  ContrastKernels contrast;
  FeatureKernels feature;
  int reach = 0;  ///< the larger radius
  std::array<double, 256> linear{};
};

/// The features of one band of one picture.
struct SeenBand {
  std::vector<glm::dvec3> color;  ///< Hunt-adjusted CIELAB, as far as the eye resolves it
  std::vector<double> edge;       ///< strength of edges, and of points, at each pixel
  std::vector<double> point;
};

/// The opponent channels and the luminance of the band's rows and those around it; pixels of the border continue
/// outside.
std::array<PicturePlane, 4> channels(const Image& image, int first, int rows, const Filters& filters) {
  const PicturePlane empty(image.width, rows + 2 * filters.reach);
  std::array<PicturePlane, 4> planes = {empty, empty, empty, empty};
  for (int y = 0; y < empty.height; ++y) {
    const int row = std::clamp(first + y - filters.reach, 0, image.height - 1);
    for (int x = 0; x < image.width; ++x) {
      const glm::u8vec3& pixel = image.at(x, row);
      const glm::dvec3 rgb(filters.linear[pixel.r], filters.linear[pixel.g], filters.linear[pixel.b]);
      const glm::dvec3 opponent = opponent_from_linear(rgb);
      for (int channel = 0; channel < 3; ++channel) {
        planes[static_cast<std::size_t>(channel)].at(x, y) = opponent[channel];
      }
      planes[3].at(x, y) = luminance_of_linear(rgb);
    }
  }
  return planes;
}

std::vector<double> lengths(const PicturePlane& x, const PicturePlane& y) {
  std::vector<double> result(x.value.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::sqrt(x.value[i] * x.value[i] + y.value[i] * y.value[i]);
  }
  return result;
}

SeenBand seen(const Image& image, int first, int rows, const Filters& filters) {
  // Filters each channel as the eye does; blue and yellow need two filters.
  const std::array<PicturePlane, 4> planes = channels(image, first, rows, filters);
  const auto blurred = [&](std::size_t channel, const Kernel& kernel) {
    return filtered(planes[channel], kernel, kernel, filters.reach);
  };
  const PicturePlane light = blurred(0, filters.contrast.light), red_green = blurred(1, filters.contrast.red_green);
  const PicturePlane wide = blurred(2, filters.contrast.blue_yellow_wide);
  const PicturePlane narrow = blurred(2, filters.contrast.blue_yellow_narrow);

  // The filtered colours, in the space of distances.
  SeenBand band;
  for (std::size_t i = 0; i < light.value.size(); ++i) {
    const glm::dvec3 rgb = linear_from_opponent({light.value[i], red_green.value[i], wide.value[i] + narrow.value[i]});
    band.color.push_back(hunt_lab_from_linear(glm::clamp(rgb, 0.0, 1.0)));
  }

  // Edges and points of the luminance, which attract the eye.
  const auto derivatives = [&](const Kernel& kernel) {
    return lengths(filtered(planes[3], kernel, filters.feature.smooth, filters.reach),
                   filtered(planes[3], filters.feature.smooth, kernel, filters.reach));
  };
  band.edge = derivatives(filters.feature.edge);
  band.point = derivatives(filters.feature.point);
  return band;
}

/// Section 4.1.3: most of the range goes to the distances that are common in pictures.
double color_error(double distance, double largest) {
  constexpr double knee = 0.4, at_knee = 0.95;
  const double bent = reproducible::pow(distance, 0.7);
  if (bent < knee * largest) return at_knee / (knee * largest) * bent;
  return at_knee + (bent - knee * largest) / (largest - knee * largest) * (1 - at_knee);
}

/// The largest possible distance: between green and blue.
double largest_bent_distance() {
  return reproducible::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
}

/// Section 4.3: differences of features amplify differences of colour.
double error_at(const SeenBand& reference, const SeenBand& result, std::size_t i, double largest) {
  const double color = color_error(hyab(reference.color[i], result.color[i]), largest);
  const double feature =
      std::max(std::fabs(reference.edge[i] - result.edge[i]), std::fabs(reference.point[i] - result.point[i]));
  const double amplified = std::sqrt(feature / std::sqrt(2.0));
  return std::clamp(reproducible::pow(color, 1 - amplified), 0.0, 1.0);
}

}  // namespace

FlipMap flip(const Image& reference, const Image& result, const FlipOptions& options) {
  if (reference.width != result.width || reference.height != result.height) {
    throw Error(ExitStatus::bad_data, "pictures of different sizes have no FLIP");
  }

  // Filters and tables that all bands share.
  Filters filters{contrast_kernels(options.pixels_per_degree), feature_kernels(options.pixels_per_degree)};
  filters.reach = std::max(filters.contrast.radius, filters.feature.radius);
  for (std::size_t i = 0; i < filters.linear.size(); ++i) {
    filters.linear[i] = linear_from_srgb(static_cast<double>(i) / 255);
  }
  const double largest = largest_bent_distance();

  // Works in bands of rows, to save memory.
  FlipMap map{reference.width, reference.height, std::vector<float>(reference.pixels.size())};
  const auto bands = static_cast<std::size_t>((reference.height + band_rows - 1) / band_rows);
  parallel_for(bands, options.threads, [&](std::size_t band) {
    const int first = static_cast<int>(band) * band_rows, rows = std::min(band_rows, reference.height - first);
    const SeenBand one = seen(reference, first, rows, filters), other = seen(result, first, rows, filters);
    const std::size_t offset = static_cast<std::size_t>(first) * static_cast<std::size_t>(reference.width);
    for (std::size_t i = 0; i < one.color.size(); ++i) {
      map.error[offset + i] = static_cast<float>(error_at(one, other, i, largest));
    }
  });
  return map;
}

double mean(const FlipMap& map) {
  if (map.error.empty()) return 0;
  return std::accumulate(map.error.begin(), map.error.end(), 0.0) / static_cast<double>(map.error.size());
}

}  // namespace pomona
