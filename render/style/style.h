// Styles: how pictures are drawn. Each has a file (styles/*.toml, style_file.h); the defaults here, which are those of
// "ink", hold for keys that a file does not state.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/base/color.h"

namespace pomona {

/// The light of a scene. Angles are radians.
struct LightStyle {
  double azimuth = -0.94;   ///< 0 = from behind the viewer, negative = from the left
  double elevation = 0.89;  ///< height above the table
  double softness = 0.35;   ///< 0 = edges of shadows are hard, 1 = they dissolve
  double strength = 1;      ///< strength of the light, times the usual
  double ambient = 1;       ///< light from all sides, times the usual
  double occlusion = 1;     ///< how much things block each other's light from all sides; 0 = not at all
  bool window = false;      ///< light as through a window, as photographs have it (shaders/window.glsl)
};

/// Shadows.
struct ShadowStyle {
  Color color{0.50f, 0.45f, 0.43f};  ///< colour of the wash for shadows, on white paper
  double strength = 1;               ///< strength of shadows; 0 = things cast none
};

/// The texts around a figure on a botanical plate. Lengths are shares of the picture's shorter side.
struct PlateStyle {
  double margin = 0.07;       ///< smallest width of empty paper
  double letter_size = 0.03;  ///< the em of labels; the title's is 1.6 times as large
  Color letter_color{0.045f, 0.028f, 0.018f};
  double leader_width = 0.0011;  ///< width of the lines from labels to parts
  bool title = true;
  bool labels = true;
  bool scale_bar = true;
};

enum class MarkKind : std::uint8_t { hatching, stipple };

/// Tones by marks of the ink instead of paint. Lengths are shares of the picture's shorter side.
struct MarkStyle {
  MarkKind kind = MarkKind::hatching;
  double spacing = 0.009;  ///< distance between lines of hatching
  double width = 0.0062;   ///< width of hatching's lines where it is darkest, or of stipple's dots
  double wash = 0;         ///< share of the paint that stays below the marks, 0..1
};

/// Lengths are shares of the picture's shorter side.
struct Style {
  std::string name;
  std::string title;               ///< title for people
  bool noise = true;               ///< Perlin modulation of colours
  bool ink = true;                 ///< strokes along silhouettes and cuts
  std::optional<Color> ink_color;  ///< colour of all strokes; without it, each template's own
  double outline_width = 0.008;    ///< largest width of silhouettes and rims of cut faces
  double inner_width = 0.0042;     ///< width of creases, and of lines on cut faces where the colour jumps
  double inner_opacity = 0.75;
  Color paper{0.93f, 0.90f, 0.83f};  ///< colour of paper, unless the scene has its own
  double grain = 0.012;              ///< strength of the paper's grain, OKLab lightness
  double vignette = 0;               ///< by how much the paper's corners are darker, OKLab lightness
  double granulation = 0;            ///< how much of the paper's grain shows in what is painted, times `grain`
  double saturation = 1;             ///< factor of painted colours' OKLab chroma
  double lightness = 0;              ///< added to painted colours, OKLab lightness
  double gloss = 1;                  ///< factor of the shine of skins
  double juice = 0;                  ///< share of juice at the rims of wet parts and on the table, in a window's light
  LightStyle light;
  ShadowStyle shadow;
  std::optional<MarkStyle> marks;   ///< hatching or stipple in place of paint
  std::optional<PlateStyle> plate;  ///< a title, labels and a scale bar around the figure
};

}  // namespace pomona
