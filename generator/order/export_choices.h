// Choices of what files hold.
#pragma once

namespace pomona {

/// The engine for whose importer names in a file are made (docs/reference/formats.md).
enum class Engine { any, godot, unreal, unity, blender };

/// How the arrays of a file are coded.
enum class Compression {
  none,
  meshopt,  ///< EXT_meshopt_compression, of numbers of 8 and 16 bits (KHR_mesh_quantization)
};

/// The axis that points up in a file.
enum class UpAxis { y, z };

/// What shares one material. Looks are told apart by maps then, and pieces of a file by their places on one texture.
enum class AtlasOf {
  none,   ///< parts of a piece that have one look
  piece,  ///< all parts of a piece
  file,   ///< all pieces of a file; their texture, too
};

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
