// What a part is made of besides its colours: how it shines, what lies on it, how far light goes in.
#pragma once

#include "generator/base/color.h"

namespace pomona {

/// The waxy veil on a skin. It whitens what is seen at a slant most, and is rubbed off in patches.
struct Bloom {
  double cover = 0;  ///< share of the skin's colour that it hides where it is whole, 0..1
  Color color{0.72f, 0.76f, 0.84f};
  double rubbed = 0.4;        ///< share of the skin where it is gone, 0..1
  double patch_size = 0.008;  ///< metres
};

/// Short hairs on a skin.
struct Fuzz {
  double length = 0;   ///< of the longest, metres
  double density = 1;  ///< hairs per square millimetre
  Color color{0.55f, 0.42f, 0.22f};
  double lie = 0.5;  ///< 0 = they stand upright, 1 = they lie on the skin
};

/// Light that goes in, is scattered there, and comes out elsewhere. After `depth` times a channel of `color`, 1/e of
/// that channel's light is left.
struct Translucency {
  double depth = 0;  ///< mean free path, metres
  Color color{1.0f};
};

/// One part's. The defaults are what a part is like of which nothing is said.
struct MaterialSketch {
  double gloss = 1;        ///< strength of the highlight on skins, 0..4
  double roughness = 0.3;  ///< how far it spreads: 0 = a mirror, 1 = dull
  double wet = 1;          ///< how wet cut faces are: strength of their sheen and highlights, 0..4
  double relief = 0;       ///< metres that the part stands proud of cut faces, or is sunk in them where negative
  double pit = 0;          ///< metres that the skin around it is sunk, where it lies on a skin
  Bloom bloom;
  Fuzz fuzz;
  Translucency translucency;
};

}  // namespace pomona
