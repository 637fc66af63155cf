// Styles: how a picture is drawn, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/base/color.h"

namespace pomona {

/// Lengths are shares of the picture's shorter side.
struct Style {
  std::string name;
  bool noise = true;             ///< Perlin modulation of colours
  bool ink = true;               ///< strokes along silhouettes and cuts
  double outline_width = 0.008;  ///< of silhouettes and of the rims of cut faces, at their widest
  double inner_width = 0.0042;   ///< of creases, and of lines on cut faces where the colour jumps
  double inner_opacity = 0.75;
  Color paper{0.93f, 0.90f, 0.83f};  ///< under section pictures; scenes bring their own
  double grain = 0.012;              ///< of the paper, OKLab lightness
  double gloss = 1;                  ///< of skins, times what the light gives
};

/// "plain": flat colour, no noise, no ink. "ink": noise, strokes and paper; the default.
std::vector<Style> all_styles();

/// \throws Error (usage) that lists the names.
Style style_named(std::string_view name);

}  // namespace pomona
