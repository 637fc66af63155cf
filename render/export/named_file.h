// One file of an output that has several.
#pragma once

#include <string>

namespace pomona {

struct NamedFile {
  std::string name;  ///< without folder
  std::string bytes;
};

}  // namespace pomona
