// A file that belongs to an output of several.
#pragma once

#include <string>

namespace pomona {

struct NamedFile {
  std::string name;  ///< without folder
  std::string bytes;
};

}  // namespace pomona
