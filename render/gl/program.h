// Shader programs. Sources are the files under shaders/, embedded when Pomona is built.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/gl/context.h"

namespace pomona {

/// Names of all embedded files.
std::vector<std::string> shader_names();

/// The embedded file with its `#include "name"` lines resolved, each file once, and with the version line in front:
/// 4.50 for compute shaders (*.comp.glsl), 3.30 for all others. `definition`, if any, is a name that is defined for the
/// text.
/// \throws Error (bug) for a name that is not there.
std::string shader_source(std::string_view name, std::string_view definition = {});

/// The same for a text that is no embedded file (tests).
std::string resolved_includes(std::string_view text, std::string_view definition = {});

/// A linked program. Destroy it while its context is current.
class Program {
 public:
  /// Makes a program from two embedded files.
  /// \throws Error (bug) with the compiler's message.
  Program(const CurrentGl& gl, std::string_view vertex_file, std::string_view fragment_file,
          std::string_view definition = {});
  /// A compute shader, from an embedded file.
  /// \throws likewise
  static Program compute(const CurrentGl& gl, std::string_view file);
  static Program from_sources(const CurrentGl& gl, const std::string& vertex, const std::string& fragment);
  Program(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  void use() const;

  // Sets uniforms of the current program; names that the compiler has removed are ignored.
  void set(const char* name, int value) const;
  void set(const char* name, unsigned value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::mat4& value) const;

 private:
  explicit Program(const GlFunctions& gl) : gl_(gl) {}
  struct Stage {
    GLenum kind;
    std::string source;
  };
  void link(std::span<const Stage> stages);

  const GlFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace pomona
