#include "cli/exhausted.h"

#include <new>
#include <stdexcept>
#include <system_error>

namespace pomona {

std::optional<std::string_view> exhausted(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  if (dynamic_cast<const std::length_error*>(&error) != nullptr) return "out of memory";
  const auto* refused = dynamic_cast<const std::system_error*>(&error);
  const bool says_so = refused != nullptr && refused->code() == std::errc::resource_unavailable_try_again;
  // TBB has no exception type for a thread that cannot be started any more, only this message.
  if (says_so || std::string_view(error.what()).starts_with("pthread_create"))
    return "the system gives no further thread";
  return {};
}

}  // namespace pomona
