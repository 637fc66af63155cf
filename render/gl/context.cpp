#include "render/gl/context.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

#include "generator/base/error.h"
#include "render/gl/platform.h"

namespace pomona {

namespace {

std::unique_ptr<GlPlatform> opened(GlRoute route) {
  switch (route) {
    case GlRoute::device:
      return open_egl_device(false);
    case GlRoute::surfaceless:
      return open_egl_surfaceless();
    case GlRoute::osmesa:
      return open_osmesa();
  }
  throw Error(ExitStatus::bug, "there is no such route to OpenGL");
}

/// The route that the environment asks for.
std::optional<GlRoute> wanted_route() {
  const char* value = std::getenv("POMONA_GL");
  if (value == nullptr || *value == '\0') return std::nullopt;
  const std::string name = value;
  if (name == "device") return GlRoute::device;
  if (name == "surfaceless") return GlRoute::surfaceless;
  if (name == "osmesa") return GlRoute::osmesa;
  throw Error(ExitStatus::usage, "POMONA_GL=" + name + " is no way to OpenGL", "use device, surfaceless or osmesa");
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

bool is_software_renderer(std::string_view renderer) {
  // As their drivers write them, lower case; a name may contain another ("zink (llvmpipe ...)", "virgl (LLVMPIPE)").
  std::string name(renderer);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* software :
       {"llvmpipe", "lavapipe", "softpipe", "swrast", "swr", "swiftshader", "software", "microsoft basic render"}) {
    if (name.find(software) != std::string::npos) return true;
  }
  return false;
}

GlContext::GlContext(GlRoute route) { open(route, opened(route)); }

GlContext::GlContext(GlRoute route, std::unique_ptr<GlPlatform> platform) { open(route, std::move(platform)); }

GlContext::GlContext() {
  if (const std::optional<GlRoute> wanted = wanted_route()) {
    try {
      open(*wanted, opened(*wanted));
    } catch (const Error& error) {
      throw Error(error.status(), "OpenGL as POMONA_GL asks for it: " + error.diagnostics().front().message,
                  "without POMONA_GL, whatever works is taken");
    }
    return;
  }

  // Graphics cards first; Mesa's software device last, because it is the newest route.
  using Opener = std::function<std::unique_ptr<GlPlatform>()>;
  const std::array<std::pair<GlRoute, Opener>, 4> ways{{{GlRoute::device, [] { return open_egl_device(true); }},
                                                        {GlRoute::surfaceless, open_egl_surfaceless},
                                                        {GlRoute::osmesa, open_osmesa},
                                                        {GlRoute::device, [] { return open_egl_device(false); }}}};
  std::string reasons;
  for (const auto& [route, opener] : ways) {
    try {
      open(route, opener());
      return;
    } catch (const Error& error) {
      reasons += (reasons.empty() ? "" : "; ") + to_string(route) + ": " + error.diagnostics().front().message;
    }
  }
  throw Error(ExitStatus::helper_missing, "no OpenGL without a display (" + reasons + ")",
              "on Debian: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri, or libosmesa6");
}

std::unique_ptr<GlContext> GlContext::on_graphics_card() {
  if (wanted_route().value_or(GlRoute::device) != GlRoute::device) return nullptr;
  try {
    std::unique_ptr<GlContext> context(new GlContext(GlRoute::device, open_egl_device(true)));
    return context->is_software() ? nullptr : std::move(context);
  } catch (const Error&) {
    return nullptr;  // there is no EGL, no card, or none that works
  }
}

GlContext::~GlContext() = default;

bool GlContext::is_software() const { return is_software_renderer(renderer_); }

void GlContext::open(GlRoute route, std::unique_ptr<GlPlatform> platform) {
  platform_ = std::move(platform);
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

  // One call may leave several errors; the first says most.
  while (context_.functions_.GetError() != GL_NO_ERROR) {
  }
  const ExitStatus status = error == GL_OUT_OF_MEMORY ? ExitStatus::helper_missing : ExitStatus::bug;
  throw Error(status, "OpenGL says " + error_name(error) + " after: " + step);
}

}  // namespace pomona
