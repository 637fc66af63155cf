// An OpenGL context without a display: on a graphics card if there is one, else in software.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/functions.h"

namespace pomona {

class GlPlatform;

/// The ways to a context.
enum class GlRoute {
  device,       ///< EGL on a device: a graphics card, or else Mesa in software (EGL_EXT_platform_device)
  surfaceless,  ///< EGL by Mesa, in software (EGL_MESA_platform_surfaceless)
  osmesa,       ///< Mesa's off-screen library, in software
};

/// An OpenGL context of version 4.5 core, else 3.3. Several may exist; a thread uses one at a time, within a CurrentGl.
class GlContext {
 public:
  /// The route that the environment variable POMONA_GL names ("device", "surfaceless", "osmesa"); without it the first
  /// that works: a graphics card, then software by each route. The libraries are loaded by this call, not at the start
  /// of the program.
  /// \throws Error (helper_missing) that says what each route lacks, (usage) if POMONA_GL names no route.
  GlContext();
  /// \throws Error (helper_missing) if this one does not work.
  explicit GlContext(GlRoute route);
  /// A context on a graphics card; null if there is none (which is quick), or POMONA_GL names another route.
  static std::unique_ptr<GlContext> on_graphics_card();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  GlRoute route() const { return route_; }
  const std::string& renderer() const { return renderer_; }  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  int version() const { return version_; }                   ///< 45 = OpenGL 4.5
  bool is_software() const;  ///< drawn by the processor, even if it is listed as a device

 private:
  friend class CurrentGl;
  GlContext(GlRoute route, std::unique_ptr<GlPlatform> platform);
  void open(GlRoute route, std::unique_ptr<GlPlatform> platform);

  GlRoute route_ = GlRoute::osmesa;
  std::unique_ptr<GlPlatform> platform_;
  GlFunctions functions_;
  std::string renderer_;
  int version_ = 0;
};

/// Makes a context this thread's current one while it exists; it cannot be nested. Its functions are called through it:
/// `gl->Clear(...)`.
class CurrentGl {
 public:
  explicit CurrentGl(GlContext& context);
  ~CurrentGl();
  CurrentGl(const CurrentGl&) = delete;
  CurrentGl& operator=(const CurrentGl&) = delete;

  const GlFunctions* operator->() const { return &context_.functions_; }
  const GlFunctions& functions() const { return context_.functions_; }

  /// \throws Error (bug) if OpenGL has reported an error since the last call; `step` names the work in between.
  void check(const std::string& step) const;

 private:
  GlContext& context_;
};

/// The name for messages: "EGL device".
std::string to_string(GlRoute route);

/// Whether OpenGL's name of its renderer is that of a software renderer.
bool is_software_renderer(std::string_view renderer);

}  // namespace pomona
