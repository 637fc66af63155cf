#include "generator/base/free_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pomona {

void give_back_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void keep_free_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  mallopt(M_TOP_PAD, 8 << 20);
#endif
}

void share_heaps([[maybe_unused]] int max) {
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, max);
#endif
}

}  // namespace pomona
