#include <array>
#include <utility>

#include <GL/osmesa.h>

#include "generator/base/error.h"
#include "render/gl/platform.h"
#include "render/gl/shared_library.h"

namespace pomona {

namespace {

class OsmesaPlatform : public GlPlatform {
 public:
  OsmesaPlatform() {
    for (const auto& [major, minor] : {std::pair{4, 5}, std::pair{3, 3}}) {
      if (context_ == nullptr) context_ = created(major, minor);
    }
    if (context_ == nullptr) throw Error(ExitStatus::helper_missing, "OSMesa: there is no OpenGL 3.3 core context");
  }
  ~OsmesaPlatform() override { library_.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext")(context_); }
  OsmesaPlatform(const OsmesaPlatform&) = delete;
  OsmesaPlatform& operator=(const OsmesaPlatform&) = delete;

  void make_current() override {
    if (switch_to(context_) == GL_FALSE) {
      throw Error(ExitStatus::helper_missing, "OSMesa: the context cannot be made current");
    }
  }
  void release() override { switch_to(nullptr); }
  void (*find(const char* name))() override {
    return library_.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress")(name);
  }

 private:
  OSMesaContext created(int major, int minor) const {
    const std::array<int, 11> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         major,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         minor,
                                         0};
    const auto create = library_.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    return create(attributes.data(), nullptr);
  }

  GLboolean switch_to(OSMesaContext context) {
    const auto make = library_.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    return context == nullptr ? make(nullptr, nullptr, 0, 0, 0)
                              : make(context, screen_.data(), GL_UNSIGNED_BYTE, side, side);
  }

  // OSMesa needs memory to draw on, although all drawing goes into framebuffer objects.
  static constexpr int side = 16;
  SharedLibrary library_{"libOSMesa.so.8"};
  std::array<unsigned char, side * side * 4> screen_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlPlatform> open_osmesa() { return std::make_unique<OsmesaPlatform>(); }

}  // namespace pomona
