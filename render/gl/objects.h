// OpenGL's objects with an owner. Destroy them while their context is current.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/gl/context.h"

namespace pomona {

/// A buffer object of a size that does not change.
class GlBuffer {
 public:
  GlBuffer(const CurrentGl& gl, GLenum target, const void* data, std::size_t bytes);
  template <typename Value>
  GlBuffer(const CurrentGl& gl, GLenum target, const std::vector<Value>& values)
      : GlBuffer(gl, target, values.data(), values.size() * sizeof(Value)) {}
  GlBuffer(GlBuffer&& other) noexcept;
  GlBuffer(const GlBuffer&) = delete;
  GlBuffer& operator=(const GlBuffer&) = delete;
  ~GlBuffer();
  GLuint id() const { return id_; }

  /// Puts bytes at this offset.
  void write(std::size_t offset, std::span<const std::byte> bytes) const;
  /// Copies the first bytes of another buffer.
  void copy(const GlBuffer& from, std::size_t bytes) const;

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

/// A texture without mipmaps: a target of drawing, or a view of a buffer.
class GlTexture {
 public:
  /// Nearest sampling, clamped. `format` is sized (GL_RGBA16F ...).
  GlTexture(const CurrentGl& gl, GLenum format, int width, int height);
  /// A buffer texture.
  GlTexture(const CurrentGl& gl, GLenum format, const GlBuffer& buffer);
  GlTexture(GlTexture&& other) noexcept;
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;
  ~GlTexture();

  void bind(int unit) const;
  GLuint id() const { return id_; }

 private:
  const GlFunctions& gl_;
  GLenum target_;
  GLuint id_ = 0;
};

/// Texels in a buffer, and its texture for shaders.
class GlTable {
 public:
  /// \param format GL_RGBA32F or GL_R16UI.
  /// \param what "triangles", for the message.
  /// \throws Error (bad_data) for more texels than this context holds.
  template <typename Value>
  GlTable(const CurrentGl& gl, GLenum format, const std::vector<Value>& values, const char* what)
      : GlTable(gl, format, values.data(), values.size() * sizeof(Value), what) {}

  const GlTexture& texture() const { return texture_; }

 private:
  GlTable(const CurrentGl& gl, GLenum format, const void* data, std::size_t bytes, const char* what);

  GlBuffer buffer_;
  GlTexture texture_;
};

/// The target of a pass: colour attachments in order, and a depth attachment or none.
class GlFramebuffer {
 public:
  GlFramebuffer(const CurrentGl& gl, std::span<const GlTexture* const> colors, const GlTexture* depth);
  GlFramebuffer(GlFramebuffer&& other) noexcept;
  GlFramebuffer(const GlFramebuffer&) = delete;
  GlFramebuffer& operator=(const GlFramebuffer&) = delete;
  ~GlFramebuffer();

  /// Makes it the target of drawing and reading.
  void bind(int width, int height) const;

 private:
  explicit GlFramebuffer(const CurrentGl& gl);

  const GlFunctions& gl_;
  GLuint id_ = 0;
};

/// A vertex array object.
class GlVertexArray {
 public:
  explicit GlVertexArray(const CurrentGl& gl);
  GlVertexArray(GlVertexArray&& other) noexcept;
  GlVertexArray(const GlVertexArray&) = delete;
  GlVertexArray& operator=(const GlVertexArray&) = delete;
  ~GlVertexArray();
  void bind() const;
  /// Floats of `buffer`, tightly packed, as attribute `index`.
  void attach(unsigned index, int components, const GlBuffer& buffer) const;

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace pomona
