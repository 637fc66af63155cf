// What CMake has made of the files under shaders/.
#pragma once

#include <span>
#include <string_view>

namespace pomona {

struct EmbeddedShader {
  std::string_view name;  ///< "noise.glsl"
  std::string_view text;
};

std::span<const EmbeddedShader> embedded_shaders();

}  // namespace pomona
