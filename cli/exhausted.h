// Whether an exception means that the machine ran out of memory or threads.
#pragma once

#include <exception>
#include <optional>
#include <string>

namespace pomona {

/// "out of memory" (for std::bad_alloc, and for std::length_error: more than a vector can hold) or "the system gives no
/// further thread"; nothing for other errors.
std::optional<std::string> exhausted(const std::exception& error);

}  // namespace pomona
