#include "render/gl/functions.h"

#include <string>

#include "generator/base/error.h"

namespace pomona {

GlFunctions load_functions(const GlLoader& loader) {
  GlFunctions gl;
#define POMONA_GL_LOAD(type, name)                                                                    \
  gl.name = reinterpret_cast<type>(loader("gl" #name));                                               \
  if (gl.name == nullptr) {                                                                           \
    throw Error(ExitStatus::helper_missing, "this OpenGL has no function " + std::string("gl" #name), \
                "pictures need OpenGL 3.3 or newer");                                                 \
  }
  POMONA_GL_FUNCTIONS(POMONA_GL_LOAD)
#undef POMONA_GL_LOAD
#define POMONA_GL_LOAD(type, name) gl.name = reinterpret_cast<type>(loader("gl" #name));
  POMONA_GL_COMPUTE_FUNCTIONS(POMONA_GL_LOAD)
#undef POMONA_GL_LOAD
  return gl;
}

}  // namespace pomona
