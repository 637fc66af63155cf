// The material of a part besides its colours: its gloss, its bloom and hairs, its translucency.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/base/color.h"

namespace pomona {

/// The waxy bloom on a skin. It is whitest at grazing angles, and is rubbed off in patches.
struct Bloom {
  double cover = 0;  ///< share of the skin's colour that it hides where it is not rubbed off, 0..1
  Color color{0.72f, 0.76f, 0.84f};
  double rubbed = 0.4;        ///< share of the skin where it is rubbed off, 0..1
  double patch_size = 0.008;  ///< metres
};

/// Short hairs on a skin.
struct Fuzz {
  double length = 0;   ///< length of the longest hairs, metres
  double density = 1;  ///< hairs per square millimetre
  Color color{0.55f, 0.42f, 0.22f};
  double lie = 0.5;  ///< 0 = they stand upright, 1 = they lie on the skin
};

/// Light that enters, is scattered and leaves elsewhere. After a length of `depth` times a channel of `color`, 1/e of
/// that channel's light remains.
struct Translucency {
  double depth = 0;  ///< mean free path, metres
  Color color{1.0f};
};

/// The kind of tissue, which determines how light is scattered inside: render/style/tissue_light.h has numbers for
/// each.
enum class Tissue : std::uint8_t { flesh, gel, pith, skin, leaf, seed, shell, mineral };

/// Light that is scattered under the surface, in the terms of path tracers.
struct Subsurface {
  double radius = 0;  ///< mean distance from where light enters to where it leaves, metres; 0 = it does not enter
  Color tint{1.0f};   ///< each channel's way is `radius` times its share of this
  double weight = 1;  ///< share of the light not reflected by the surface that enters, 0..1
};

/// The material of one part. The defaults are those of a part without a description.
struct MaterialSketch {
  double gloss = 1;        ///< strength of the highlight on skins, 0..4
  double roughness = 0.3;  ///< how far it spreads: 0 = a mirror, 1 = dull
  double wet = 1;          ///< how wet cut faces are: strength of their sheen and highlights, 0..4
  double relief = 0;       ///< height of the part above cut faces, metres, negative = below
  double pit = 0;          ///< depth of the pit around it where it lies on a skin, metres
  Bloom bloom;
  Fuzz fuzz;
  Translucency translucency;

  // For path tracers only. Values that are not given follow from tissue_light.h.
  std::optional<Tissue> tissue;          ///< without it, by the part's name
  std::optional<Subsurface> subsurface;  ///< without it, by `translucency`, else by the tissue
  std::optional<double> transmission;    ///< share of light that goes straight through, as through glass, 0..1
  std::optional<double> coat;            ///< share of a clear, smooth film, 0..1; without it, by `wet` or `gloss`
};

}  // namespace pomona
