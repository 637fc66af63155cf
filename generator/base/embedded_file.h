// Files of the source tree that become part of the program: shaders, styles, letters. CMake's pomona_embed() makes the
// functions that return them.
#pragma once

#include <string_view>

namespace pomona {

struct EmbeddedFile {
  std::string_view name;  ///< "noise.glsl"
  std::string_view text;

  /// "noise"
  std::string_view stem() const { return name.substr(0, name.rfind('.')); }
};

}  // namespace pomona
