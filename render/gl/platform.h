// The three routes to a context; each throws Error (helper_missing) with what it lacks.
#pragma once

#include <memory>

namespace pomona {

/// A context of one of the libraries.
class GlPlatform {
 public:
  virtual ~GlPlatform() = default;
  virtual void make_current() = 0;
  virtual void release() = 0;
  virtual void (*find(const char* name))() = 0;  ///< an entry point, or null
};

/// The first device that works: graphics cards first; then, unless `cards_only`, the software renderer that Mesa lists
/// as a device.
std::unique_ptr<GlPlatform> open_egl_device(bool cards_only);
std::unique_ptr<GlPlatform> open_egl_surfaceless();
std::unique_ptr<GlPlatform> open_osmesa();

}  // namespace pomona
