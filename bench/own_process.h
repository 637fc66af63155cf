// Work in a process of its own, so that its peak of memory is its own.
#pragma once

#include <functional>
#include <string>

namespace pomona::bench {

/// What `work` returns there. Errors end the other process, which has told them on standard error.
/// \throws std::runtime_error if there is no other process, or it came to no end.
std::string in_own_process(const std::function<std::string()>& work);

}  // namespace pomona::bench
