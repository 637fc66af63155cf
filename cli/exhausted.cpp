#include "cli/exhausted.h"

#include <new>
#include <stdexcept>
#include <system_error>

namespace pomona {

std::optional<std::string> exhausted(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  if (dynamic_cast<const std::length_error*>(&error) != nullptr) return "out of memory";
  const auto* refused = dynamic_cast<const std::system_error*>(&error);
  if (refused != nullptr && refused->code() == std::errc::resource_unavailable_try_again)
    return "the system gives no further thread";
  return {};
}

}  // namespace pomona
