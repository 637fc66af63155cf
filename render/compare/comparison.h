// Whether two pictures count as the same, and by how much they differ.
#pragma once

#include <string>
#include <vector>

#include "render/compare/flip.h"
#include "render/image/png.h"

namespace pomona {

/// How far apart two pictures may be and still count as the same. The default allows nothing.
struct Tolerance {
  int usual = 0;          ///< of 255, in any channel of a pixel
  double exceptions = 0;  ///< share of the pixels (0..1) that may differ by more than that
  int never = 0;          ///< of 255: what not even an exception may exceed
  double flip = 0;        ///< largest mean FLIP
};

/// For what OpenGL or POV-Ray drew: processors and drivers differ by about so much, and eyes see no difference.
constexpr Tolerance close_tolerance{.usual = 3, .exceptions = 0.001, .never = 32, .flip = 0.005};

struct Comparison {
  bool same = false;
  std::vector<std::string> reasons;  ///< why they do not count as the same, for people
  int largest = 0;                   ///< of 255: largest difference of a channel, opacity included
  std::size_t different = 0;         ///< pixels that differ at all
  std::size_t beyond = 0;            ///< pixels that differ by more than the tolerance's `usual`
  double flip = 0;                   ///< mean
  FlipMap map;                       ///< empty for pictures of different sizes
};

/// What is see-through is compared as it looks on white; opacity counts as a channel of its own.
Comparison compared(const TransparentImage& reference, const TransparentImage& result, const Tolerance& tolerance,
                    const FlipOptions& options = {});

/// What a picture shows on white.
Image laid_on_white(const TransparentImage& picture);

}  // namespace pomona
