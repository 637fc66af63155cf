// What the machine had too little of, where an exception says that.
#pragma once

#include <exception>
#include <optional>
#include <string>

namespace pomona {

/// "out of memory" or "the system gives no further thread", or nothing where `error` is about something else. The first
/// is what std::bad_alloc says and std::length_error, which is more than any vector can hold.
std::optional<std::string> exhausted(const std::exception& error);

}  // namespace pomona
