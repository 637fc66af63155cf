#include "render/gl/context.h"

#include "generator/base/error.h"
#include "render/gl/platform.h"

namespace pomona {

namespace {

std::unique_ptr<GlPlatform> opened(GlRoute route) {
  switch (route) {
    case GlRoute::device:
      return open_egl_device();
    case GlRoute::surfaceless:
      return open_egl_surfaceless();
    case GlRoute::osmesa:
      return open_osmesa();
  }
  throw Error(ExitStatus::bug, "there is no such route to OpenGL");
}

/// The error's name as the specification spells it.
std::string error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "error " + std::to_string(error);
  }
}

}  // namespace

std::string to_string(GlRoute route) {
  switch (route) {
    case GlRoute::device:
      return "EGL device";
    case GlRoute::surfaceless:
      return "EGL surfaceless";
    case GlRoute::osmesa:
      return "OSMesa";
  }
  return "?";
}

GlContext::GlContext(GlRoute route) { open(route); }

GlContext::GlContext() {
  std::string reasons;
  for (const GlRoute route : {GlRoute::device, GlRoute::surfaceless, GlRoute::osmesa}) {
    try {
      open(route);
      return;
    } catch (const Error& error) {
      reasons += (reasons.empty() ? "" : "; ") + to_string(route) + ": " + error.diagnostics().front().message;
    }
  }
  throw Error(ExitStatus::helper_missing, "no OpenGL to draw with (" + reasons + ")",
              "on Debian: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri, or libosmesa6");
}

GlContext::~GlContext() = default;

void GlContext::open(GlRoute route) {
  platform_ = opened(route);
  route_ = route;
  platform_->make_current();
  try {
    functions_ = load_functions([this](const char* name) { return platform_->find(name); });
    renderer_ = reinterpret_cast<const char*>(functions_.GetString(GL_RENDERER));
    GLint major = 0, minor = 0;
    functions_.GetIntegerv(GL_MAJOR_VERSION, &major);
    functions_.GetIntegerv(GL_MINOR_VERSION, &minor);
    version_ = 10 * major + minor;
  } catch (...) {
    platform_->release();
    throw;
  }
  platform_->release();
}

CurrentGl::CurrentGl(GlContext& context) : context_(context) { context_.platform_->make_current(); }

CurrentGl::~CurrentGl() { context_.platform_->release(); }

void CurrentGl::check(const std::string& step) const {
  const GLenum error = context_.functions_.GetError();
  if (error == GL_NO_ERROR) return;

  // One call may leave several notes; the first says most.
  while (context_.functions_.GetError() != GL_NO_ERROR) {
  }
  const ExitStatus status = error == GL_OUT_OF_MEMORY ? ExitStatus::helper_missing : ExitStatus::bug;
  throw Error(status, "OpenGL says " + error_name(error) + " after: " + step);
}

}  // namespace pomona
