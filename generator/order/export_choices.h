// What files can be asked to hold.
#pragma once

namespace pomona {

/// Whose importer the names in a file are for (docs/reference/formats.md).
enum class Engine { any, godot, unreal, unity };

/// What textures hold.
enum class Maps {
  color,  ///< base colour alone
  all,    ///< relief, occlusion, roughness and thickness, too
};

/// How the ground truth of a picture is written.
enum class TruthFormat {
  png,  ///< 16-bit pictures of numbers, one a layer
  exr,  ///< one file with all layers as they are, and Cryptomatte
};

}  // namespace pomona
