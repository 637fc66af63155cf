// Styles: how a picture is drawn. Each is declared in a file of its own (styles/*.toml, style_file.h); the values that
// a file does not state are those given here, which are also those of "ink".
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/base/color.h"

namespace pomona {

/// Where the light of a scene comes from and how it falls. Angles are radians.
struct LightStyle {
  double azimuth = -0.94;   ///< from behind the one who looks; negative from the left
  double elevation = 0.89;  ///< above the table
  double softness = 0.35;   ///< 0 = edges of shadows are hard, 1 = they dissolve
  double strength = 1;      ///< of the light itself, times the usual
  double ambient = 1;       ///< of what comes from all sides, times the usual
  double occlusion = 1;     ///< how far surroundings take each other's light from all sides; 0 = not at all
};

/// What the light does not reach.
struct ShadowStyle {
  Color color{0.50f, 0.45f, 0.43f};  ///< of the wash that stands for it, on white paper
  double strength = 1;               ///< 0 = things cast none
};

/// What lies around a figure on a botanical plate. Lengths are shares of the picture's shorter side.
struct PlateStyle {
  double margin = 0.07;       ///< of empty paper, at least
  double letter_size = 0.03;  ///< the em of labels; the title's is 1.6 times as large
  Color letter_color{0.045f, 0.028f, 0.018f};
  double leader_width = 0.0011;  ///< of the lines from labels to parts
  bool title = true;
  bool labels = true;
  bool scale_bar = true;
};

enum class MarkKind : std::uint8_t { hatching, stipple };

/// Tones by marks of the ink instead of paint. Lengths are shares of the picture's shorter side.
struct MarkStyle {
  MarkKind kind = MarkKind::hatching;
  double spacing = 0.009;  ///< of hatching, from line to line
  double width = 0.0062;   ///< of hatching's lines in full dark, or of stipple's dots
  double wash = 0;         ///< share of the paint that stays below the marks, 0..1
};

/// Lengths are shares of the picture's shorter side.
struct Style {
  std::string name;
  std::string title;               ///< for people
  bool noise = true;               ///< Perlin modulation of colours
  bool ink = true;                 ///< strokes along silhouettes and cuts
  std::optional<Color> ink_color;  ///< of all strokes; without it, each template's own
  double outline_width = 0.008;    ///< of silhouettes and of the rims of cut faces, at their widest
  double inner_width = 0.0042;     ///< of creases, and of lines on cut faces where the colour jumps
  double inner_opacity = 0.75;
  Color paper{0.93f, 0.90f, 0.83f};  ///< where a scene does not bring its own
  double grain = 0.012;              ///< of the paper, OKLab lightness
  double vignette = 0;               ///< by how much the paper's corners are darker, OKLab lightness
  double granulation = 0;            ///< how much of the paper's grain shows in what is painted, times `grain`
  double saturation = 1;             ///< of what is painted: OKLab chroma times this
  double lightness = 0;              ///< added to what is painted, OKLab lightness
  double gloss = 1;                  ///< of skins, times what the light gives
  LightStyle light;
  ShadowStyle shadow;
  std::optional<MarkStyle> marks;   ///< hatching or stipple in place of paint
  std::optional<PlateStyle> plate;  ///< a title, labels and a scale bar around the figure
};

}  // namespace pomona
