// Browning of a fruit's cut faces in air.
#pragma once

#include <optional>
#include <vector>

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

/// Browning t: 0 = just cut, 1 = left lying for long. A place of a cut face has come
///   w = most (1 - exp(-3 t rate speed near (1 + patches noise)))
/// of the way, in OKLab, from its colour to its part's `color`. `speed` depends on the depth below the skin. `near`
/// grows linearly from 1 at `within` to `faster` on a surface where cells brown first, such as the core or a bundle.
struct BrowningSketch {
  struct Part {
    int part = 0;  ///< index into Template::parts
    Color color{0.3f, 0.15f, 0.05f};
    double rate = 1;
    double max = 0.8;  ///< share, 0..1
  };
  struct Near {
    int surface = 0;  ///< index into Template::surfaces
    double within = 0;
    double faster = 1;
  };
  std::vector<Part> parts;
  Ramp<double> depth = Ramp<double>::constant(1);  ///< speed by the depth below the skin, metres
  std::optional<Near> near;
  double patches = 0;        ///< share, 0..1
  double patch_size = 0.01;  ///< metres

  bool declared() const { return !parts.empty(); }
};

}  // namespace pomona
