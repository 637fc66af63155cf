#include "render/gl/objects.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

GlBuffer::GlBuffer(const CurrentGl& gl, GLenum target, const void* data, std::size_t bytes) : gl_(gl.functions()) {
  gl_.GenBuffers(1, &id_);
  gl_.BindBuffer(target, id_);

  // A buffer of no bytes cannot be bound to a range or a texture.
  const bool empty = bytes == 0;
  gl_.BufferData(target, static_cast<GLsizeiptr>(empty ? 16 : bytes), empty ? nullptr : data, GL_STATIC_DRAW);
}

GlBuffer::GlBuffer(GlBuffer&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

GlBuffer::~GlBuffer() {
  if (id_ != 0) gl_.DeleteBuffers(1, &id_);
}

void GlBuffer::write(std::size_t offset, std::span<const std::byte> bytes) const {
  gl_.BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  gl_.BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                    bytes.data());
}

void GlBuffer::copy(const GlBuffer& from, std::size_t bytes) const {
  gl_.BindBuffer(GL_COPY_READ_BUFFER, from.id_);
  gl_.BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  gl_.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
}

namespace {

struct PixelLayout {
  GLenum format, type;
};

/// Any layout that TexImage2D accepts with a sized format; no pixels are passed.
PixelLayout layout_of(GLenum format) {
  switch (format) {
    case GL_DEPTH_COMPONENT32F:
      return {GL_DEPTH_COMPONENT, GL_FLOAT};
    case GL_R32UI:
      return {GL_RED_INTEGER, GL_UNSIGNED_INT};
    case GL_R32I:
      return {GL_RED_INTEGER, GL_INT};
    case GL_RG32I:
      return {GL_RG_INTEGER, GL_INT};
    default:
      return {GL_RGBA, GL_UNSIGNED_BYTE};
  }
}

}  // namespace

GlTexture::GlTexture(const CurrentGl& gl, GLenum format, int width, int height)
    : gl_(gl.functions()), target_(GL_TEXTURE_2D) {
  gl_.GenTextures(1, &id_);
  gl_.BindTexture(target_, id_);
  const PixelLayout layout = layout_of(format);
  gl_.TexImage2D(target_, 0, static_cast<GLint>(format), width, height, 0, layout.format, layout.type, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl_.TexParameteri(target_, filter, GL_NEAREST);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    gl_.TexParameteri(target_, wrap, GL_CLAMP_TO_EDGE);
  }
}

GlTexture::GlTexture(const CurrentGl& gl, GLenum format, const GlBuffer& buffer)
    : gl_(gl.functions()), target_(GL_TEXTURE_BUFFER) {
  gl_.GenTextures(1, &id_);
  gl_.BindTexture(target_, id_);
  gl_.TexBuffer(target_, format, buffer.id());
}

GlTexture::GlTexture(GlTexture&& other) noexcept
    : gl_(other.gl_), target_(other.target_), id_(std::exchange(other.id_, 0)) {}

GlTexture::~GlTexture() {
  if (id_ != 0) gl_.DeleteTextures(1, &id_);
}

namespace {

/// The number of bytes, if a buffer texture can hold it.
std::size_t fitting(const CurrentGl& gl, GLenum format, std::size_t bytes, const char* what) {
  const std::size_t texels = bytes / (format == GL_R16UI ? 2 : 16);
  GLint max = 0;
  gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &max);
  if (texels <= static_cast<std::size_t>(max)) return bytes;
  throw Error(ExitStatus::bad_data, "the scene has " + std::to_string(texels) + " texels of " + what +
                                        "; this OpenGL draws at most " + std::to_string(max));
}

}  // namespace

GlTable::GlTable(const CurrentGl& gl, GLenum format, const void* data, std::size_t bytes, const char* what)
    : buffer_(gl, GL_TEXTURE_BUFFER, data, fitting(gl, format, bytes, what)), texture_(gl, format, buffer_) {}

void GlTexture::bind(int unit) const {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(target_, id_);
}

GlFramebuffer::GlFramebuffer(const CurrentGl& gl) : gl_(gl.functions()) { gl_.GenFramebuffers(1, &id_); }

GlFramebuffer::GlFramebuffer(const CurrentGl& gl, std::span<const GlTexture* const> colors, const GlTexture* depth)
    : GlFramebuffer(gl) {  // the base is complete, so the object is deleted if the rest throws
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  std::vector<GLenum> targets;
  for (const GlTexture* color : colors) {
    targets.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(targets.size()));
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, targets.back(), GL_TEXTURE_2D, color->id(), 0);
  }
  if (depth != nullptr) {
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth->id(), 0);
  }
  if (targets.empty()) {
    targets.push_back(GL_NONE);
    gl_.ReadBuffer(GL_NONE);
  }
  gl_.DrawBuffers(static_cast<GLsizei>(targets.size()), targets.data());
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ExitStatus::helper_missing, "this OpenGL cannot draw into the kinds of picture that Pomona needs");
  }
}

GlFramebuffer::GlFramebuffer(GlFramebuffer&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

GlFramebuffer::~GlFramebuffer() {
  if (id_ != 0) gl_.DeleteFramebuffers(1, &id_);
}

void GlFramebuffer::bind(int width, int height) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  gl_.Viewport(0, 0, width, height);
}

GlVertexArray::GlVertexArray(const CurrentGl& gl) : gl_(gl.functions()) { gl_.GenVertexArrays(1, &id_); }

GlVertexArray::GlVertexArray(GlVertexArray&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

GlVertexArray::~GlVertexArray() {
  if (id_ != 0) gl_.DeleteVertexArrays(1, &id_);
}

void GlVertexArray::bind() const { gl_.BindVertexArray(id_); }

void GlVertexArray::attach(unsigned index, int components, const GlBuffer& buffer) const {
  bind();
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl_.EnableVertexAttribArray(index);
  gl_.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace pomona
