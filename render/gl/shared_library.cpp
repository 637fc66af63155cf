#include "render/gl/shared_library.h"

#include <dlfcn.h>

#include "generator/base/error.h"

namespace pomona {

SharedLibrary::SharedLibrary(const std::string& file)
    : file_(file), handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
  if (handle_ == nullptr) throw Error(ExitStatus::helper_missing, "there is no library " + file);
}

void* SharedLibrary::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw Error(ExitStatus::helper_missing, file_ + " has no function " + name);
  return found;
}

}  // namespace pomona
