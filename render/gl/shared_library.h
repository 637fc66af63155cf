// A shared library that is loaded at run time, so that the program starts without it.
#pragma once

#include <string>

namespace pomona {

/// Stays loaded until the process ends, because graphics drivers may not survive unloading.
class SharedLibrary {
 public:
  /// \throws Error (helper_missing) that names the library.
  explicit SharedLibrary(const std::string& file);

  /// The function of that name.
  /// \throws Error (helper_missing) if there is none.
  template <typename Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  std::string file_;
  void* handle_ = nullptr;
};

}  // namespace pomona
