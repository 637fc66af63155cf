// Whether an exception means that the machine ran out of memory or threads.
#pragma once

#include <exception>
#include <optional>
#include <string_view>

namespace pomona {

/// "out of memory" (for std::bad_alloc, and for std::length_error: more than a vector can hold) or "the system gives no
/// further thread"; nothing for other errors. Allocates nothing.
std::optional<std::string_view> exhausted(const std::exception& error);

}  // namespace pomona
