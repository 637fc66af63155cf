#include "generator/knife/knife.h"

#include "generator/base/error.h"

namespace pomona {

void refuse_knife(std::string_view text, const std::string& why, const std::string& hint) {
  throw Error(ExitStatus::usage, "knife \"" + std::string(text) + "\" " + why, hint);
}

}  // namespace pomona
