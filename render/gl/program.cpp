#include "render/gl/program.h"

#include <array>
#include <set>
#include <utility>

#include "generator/base/error.h"
#include "render/gl/embedded_shaders.h"

namespace pomona {

namespace {

constexpr std::string_view version_line = "#version 330 core\n";
constexpr std::string_view compute_version_line = "#version 450 core\n";

std::string_view embedded_text(std::string_view name) {
  for (const EmbeddedFile& shader : embedded_shaders()) {
    if (shader.name == name) return shader.text;
  }
  throw Error(ExitStatus::bug, "there is no shader " + std::string(name));
}

/// Appends the text line by line; an include line is replaced by its file, once.
void append_resolved(std::string_view text, std::set<std::string, std::less<>>& seen, std::string& result) {
  constexpr std::string_view include = "#include \"";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    if (line.substr(0, include.size()) != include) {
      result += line;
      continue;
    }
    const std::string name(line.substr(include.size(), line.find('"', include.size()) - include.size()));
    if (seen.insert(name).second) append_resolved(embedded_text(name), seen, result);
  }
}

/// Puts the version line and a definition, if any, in front.
std::string resolved(std::string_view version, std::string_view text, std::string_view definition) {
  std::string result(version);
  if (!definition.empty()) result += "#define " + std::string(definition) + "\n";
  std::set<std::string, std::less<>> seen;
  append_resolved(text, seen, result);
  return result;
}

GLuint compiled(const GlFunctions& gl, GLenum stage, const std::string& source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;

  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  gl.DeleteShader(shader);
  throw Error(ExitStatus::bug, "a shader does not compile: " + log);
}

}  // namespace

std::vector<std::string> shader_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& shader : embedded_shaders()) names.emplace_back(shader.name);
  return names;
}

std::string resolved_includes(std::string_view text, std::string_view definition) {
  return resolved(version_line, text, definition);
}

std::string shader_source(std::string_view name, std::string_view definition) {
  const bool computes = name.find(".comp.") != std::string_view::npos;
  return resolved(computes ? compute_version_line : version_line, embedded_text(name), definition);
}

Program::Program(const CurrentGl& gl, std::string_view vertex_file, std::string_view fragment_file,
                 std::string_view definition)
    : Program(gl.functions()) {
  try {
    link(std::array<Stage, 2>{{{GL_VERTEX_SHADER, shader_source(vertex_file, definition)},
                               {GL_FRAGMENT_SHADER, shader_source(fragment_file, definition)}}});
  } catch (const Error& error) {
    throw Error(error.status(), std::string(vertex_file) + " + " + std::string(fragment_file) + ": " +
                                    error.diagnostics().front().message);
  }
}

Program Program::from_sources(const CurrentGl& gl, const std::string& vertex, const std::string& fragment) {
  Program program(gl.functions());
  program.link(std::array<Stage, 2>{{{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}});
  return program;
}

Program Program::compute(const CurrentGl& gl, std::string_view file) {
  Program program(gl.functions());
  try {
    program.link(std::array<Stage, 1>{{{GL_COMPUTE_SHADER, shader_source(file)}}});
  } catch (const Error& error) {
    throw Error(error.status(), std::string(file) + ": " + error.diagnostics().front().message);
  }
  return program;
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

Program::~Program() {
  if (id_ != 0) gl_.DeleteProgram(id_);
}

void Program::link(std::span<const Stage> stages) {
  id_ = gl_.CreateProgram();
  for (const Stage& stage : stages) {
    const GLuint shader = compiled(gl_, stage.kind, stage.source);
    gl_.AttachShader(id_, shader);
    gl_.DeleteShader(shader);  // it is deleted with the program
  }
  gl_.LinkProgram(id_);
  GLint good = GL_FALSE;
  gl_.GetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return;

  std::string log(4096, '\0');
  GLsizei length = 0;
  gl_.GetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw Error(ExitStatus::bug, "shaders do not link: " + log);
}

void Program::use() const { gl_.UseProgram(id_); }

void Program::set(const char* name, int value) const { gl_.Uniform1i(gl_.GetUniformLocation(id_, name), value); }

void Program::set(const char* name, unsigned value) const { gl_.Uniform1ui(gl_.GetUniformLocation(id_, name), value); }

void Program::set(const char* name, float value) const { gl_.Uniform1f(gl_.GetUniformLocation(id_, name), value); }

void Program::set(const char* name, const glm::vec2& value) const {
  gl_.Uniform2f(gl_.GetUniformLocation(id_, name), value.x, value.y);
}

void Program::set(const char* name, const glm::vec3& value) const {
  gl_.Uniform3f(gl_.GetUniformLocation(id_, name), value.x, value.y, value.z);
}

void Program::set(const char* name, const glm::mat4& value) const {
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(id_, name), 1, GL_FALSE, &value[0][0]);
}

}  // namespace pomona
