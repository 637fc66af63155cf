#include "bench/exit_status.h"

#include <cstdio>

#include "generator/base/error.h"

namespace pomona::bench {

int exit_status_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.status());
  }
}

}  // namespace pomona::bench
