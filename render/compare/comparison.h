// Whether two pictures count as the same, and by how much they differ.
#pragma once

#include <string>
#include <vector>

#include "render/compare/flip.h"
#include "render/image/png.h"

namespace pomona {

/// How far apart two pictures may be and still count as the same. The default allows nothing.
struct Tolerance {
  int usual = 0;          ///< difference in any channel of a pixel, of 255
  double exceptions = 0;  ///< share of the pixels (0..1) that may differ by more than that
  int never = 0;          ///< limit even for exceptions, of 255
  double flip = 0;        ///< largest mean FLIP
};

/// For pictures of OpenGL or POV-Ray: processors and drivers differ by about this much, which eyes do not see.
constexpr Tolerance close_tolerance{.usual = 3, .exceptions = 0.001, .never = 32, .flip = 0.005};

struct Comparison {
  bool same = false;
  std::vector<std::string> reasons;  ///< why they do not count as the same, in words
  int largest = 0;                   ///< largest difference of a channel, opacity included, of 255
  std::size_t different = 0;         ///< pixels that differ at all
  std::size_t beyond = 0;            ///< pixels that differ by more than the tolerance's `usual`
  double flip = 0;                   ///< mean
  FlipMap map;                       ///< empty for pictures of different sizes
};

/// Transparent pixels are compared as they look on white; opacity counts as a channel.
Comparison compared(const TransparentImage& reference, const TransparentImage& result, const Tolerance& tolerance,
                    const FlipOptions& options = {});

/// A picture on a white ground.
Image laid_on_white(const TransparentImage& picture);

}  // namespace pomona
