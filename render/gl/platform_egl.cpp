#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "generator/base/error.h"
#include "render/gl/platform.h"
#include "render/gl/shared_library.h"

namespace pomona {

namespace {

[[noreturn]] void fail(const std::string& why) { throw Error(ExitStatus::helper_missing, "EGL: " + why); }

/// EGL's functions, by its own loader.
struct Egl {
  SharedLibrary library{"libEGL.so.1"};
  PFNEGLGETPROCADDRESSPROC find = library.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");

  template <typename Function>
  Function function(const char* name) const {
    const auto found = reinterpret_cast<Function>(find(name));
    if (found == nullptr) fail(std::string("there is no ") + name);
    return found;
  }
};

class EglPlatform : public GlPlatform {
 public:
  EglPlatform(const Egl& egl, EGLDisplay display) : egl_(egl), display_(display) {
    const auto initialize = egl_.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    if (initialize(display_, nullptr, nullptr) == EGL_FALSE) fail("the display cannot be initialised");
    for (const auto& [major, minor] : {std::pair{4, 5}, std::pair{3, 3}}) {
      if (context_ == EGL_NO_CONTEXT) context_ = created(major, minor);
    }
    if (context_ == EGL_NO_CONTEXT) fail("there is no OpenGL 3.3 core context");
  }

  // The display stays open, because EGL shares it among all contexts of the process.
  ~EglPlatform() override { egl_.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(display_, context_); }
  EglPlatform(const EglPlatform&) = delete;
  EglPlatform& operator=(const EglPlatform&) = delete;

  void make_current() override {
    egl_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    if (switch_to(context_) == EGL_FALSE) fail("the context cannot be made current");
  }
  void release() override { switch_to(EGL_NO_CONTEXT); }
  void (*find(const char* name))() override { return egl_.find(name); }

 private:
  EGLContext created(int major, int minor) const {
    egl_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    const std::array<EGLint, 7> attributes{
        EGL_CONTEXT_MAJOR_VERSION,           major,   EGL_CONTEXT_MINOR_VERSION, minor, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    return egl_.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                                                      attributes.data());
  }

  EGLBoolean switch_to(EGLContext context) const {
    return egl_.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }

  Egl egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

EGLDisplay platform_display(const Egl& egl, EGLenum platform, void* native) {
  const auto get = egl.function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  EGLDisplay display = get(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY) fail("there is no such display");
  return display;
}

/// All devices that EGL knows, graphics cards before software renderers.
struct EglDevices {
  std::vector<EGLDeviceEXT> cards, software;
};

EglDevices listed_devices(const Egl& egl) {
  const auto query = egl.function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto describe = egl.function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  std::array<EGLDeviceEXT, 64> found{};
  EGLint count = 0;
  if (query(static_cast<EGLint>(found.size()), found.data(), &count) == EGL_FALSE) fail("no list of devices");

  EglDevices devices;
  for (EGLint i = 0; i < count; ++i) {
    const char* extensions = describe(found[i], EGL_EXTENSIONS);
    const std::string_view text = extensions == nullptr ? "" : extensions;
    const bool is_software = text.find("EGL_MESA_device_software") != std::string_view::npos;
    (is_software ? devices.software : devices.cards).push_back(found[i]);
  }
  return devices;
}

}  // namespace

std::unique_ptr<GlPlatform> open_egl_device(bool cards_only) {
  const Egl egl;
  const EglDevices devices = listed_devices(egl);
  std::vector<EGLDeviceEXT> wanted = devices.cards;
  if (!cards_only) wanted.insert(wanted.end(), devices.software.begin(), devices.software.end());

  // A machine may have cards that this user may not use, or that need another driver.
  std::string reasons;
  for (const EGLDeviceEXT device : wanted) {
    try {
      return std::make_unique<EglPlatform>(egl, platform_display(egl, EGL_PLATFORM_DEVICE_EXT, device));
    } catch (const Error& error) {
      reasons += (reasons.empty() ? "" : "; ") + error.diagnostics().front().message;
    }
  }
  fail(wanted.empty() ? "there is no graphics card" : "no device works (" + reasons + ")");
}

std::unique_ptr<GlPlatform> open_egl_surfaceless() {
  const Egl egl;
  return std::make_unique<EglPlatform>(egl, platform_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
}

}  // namespace pomona
