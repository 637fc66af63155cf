// Choices of what files hold.
#pragma once

namespace pomona {

/// The engine for whose importer names in a file are made (docs/reference/formats.md).
enum class Engine { any, godot, unreal, unity };

/// The maps of textures.
enum class Maps {
  color,  ///< base colour alone
  all,    ///< relief, occlusion, roughness and thickness, too
};

/// The format of a picture's ground truth.
enum class TruthFormat {
  png,  ///< 16-bit pictures of numbers, one a layer
  exr,  ///< one file with all layers as they are, and Cryptomatte
};

}  // namespace pomona
