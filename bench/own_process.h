// Work in a process of its own, so that its peak of memory is its own.
#pragma once

#include <functional>
#include <string>

namespace pomona::bench {

/// Runs `work` in another process and returns its result. Errors end that process, which prints them to standard error.
/// \throws std::runtime_error if the other process cannot be started or fails.
std::string in_own_process(const std::function<std::string()>& work);

}  // namespace pomona::bench
