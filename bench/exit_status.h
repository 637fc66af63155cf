// How every benchmark ends after an error.
#pragma once

#include <functional>

namespace pomona::bench {

/// Returns what `work` returns; if it throws an Error, prints it to standard error and returns its status.
int exit_status_of(const std::function<int()>& work);

}  // namespace pomona::bench
