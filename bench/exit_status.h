// What every benchmark does with an error.
#pragma once

#include <functional>

namespace pomona::bench {

/// What `work` returns; an Error is told on standard error, and its status returned.
int exit_status_of(const std::function<int()>& work);

}  // namespace pomona::bench
