#include "render/compare/comparison.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace pomona {

namespace {

std::string size_of(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

/// Largest difference of a channel at every pixel, of 255.
std::vector<int> channel_differences(const TransparentImage& reference, const TransparentImage& result,
                                     const Image& one, const Image& other) {
  std::vector<int> differences;
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    int difference = std::abs(reference.opacity[i] - result.opacity[i]);
    for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(one.pixels[i][c] - other.pixels[i][c]));
    differences.push_back(difference);
  }
  return differences;
}

template <typename... Values>
std::string text(const char* format, Values... values) {
  char line[160];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::vector<std::string> violations(const Comparison& found, const Tolerance& allowed) {
  std::vector<std::string> reasons;
  const double pixels = static_cast<double>(found.map.error.size());
  if (static_cast<double>(found.beyond) > allowed.exceptions * pixels) {
    reasons.push_back(text("%zu pixels (%.3f %%) differ by more than %d of 255; %.3f %% may", found.beyond,
                           100 * static_cast<double>(found.beyond) / pixels, allowed.usual, 100 * allowed.exceptions));
  }
  if (found.largest > std::max(allowed.usual, allowed.never)) {
    reasons.push_back(text("a pixel differs by %d of 255; at most %d is allowed", found.largest,
                           std::max(allowed.usual, allowed.never)));
  }
  if (found.flip > allowed.flip) {
    reasons.push_back(text("the mean FLIP is %.6f; at most %g is allowed", found.flip, allowed.flip));
  }
  return reasons;
}

}  // namespace

Image laid_on_white(const TransparentImage& picture) {
  Image image = picture.image;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int opacity = picture.opacity[i];
    for (int c = 0; c < 3; ++c) {
      const int mixed = image.pixels[i][c] * opacity + 255 * (255 - opacity);
      image.pixels[i][c] = static_cast<unsigned char>((mixed + 127) / 255);
    }
  }
  return image;
}

Comparison compared(const TransparentImage& reference, const TransparentImage& result, const Tolerance& tolerance,
                    const FlipOptions& options) {
  Comparison found;
  if (reference.image.width != result.image.width || reference.image.height != result.image.height) {
    found.reasons = {"the sizes differ: " + size_of(reference.image) + " and " + size_of(result.image)};
    return found;
  }
  const Image one = laid_on_white(reference), other = laid_on_white(result);
  for (const int difference : channel_differences(reference, result, one, other)) {
    found.largest = std::max(found.largest, difference);
    found.different += difference > 0 ? 1 : 0;
    found.beyond += difference > tolerance.usual ? 1 : 0;
  }
  found.map = flip(one, other, options);
  found.flip = mean(found.map);
  found.reasons = violations(found, tolerance);
  found.same = found.reasons.empty();
  return found;
}

}  // namespace pomona
