#include "generator/diffusion/harmonic/large_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>

namespace pomona {

namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;

/// Arrays of at least this size, bytes, get large pages.
constexpr std::size_t worth_it = large_page / 4 * 3;

constexpr std::size_t cache_line = 64;

/// More than any machine has, and so small that no sum of sizes overflows.
constexpr std::size_t max_bytes = std::size_t{1} << 48;

std::size_t rounded_up(std::size_t bytes, std::size_t step) { return (bytes + step - 1) / step * step; }

}  // namespace

void* allocate_large(std::size_t bytes) {
  if (bytes > max_bytes) throw std::bad_alloc();
  const std::size_t alignment = bytes >= worth_it ? large_page : cache_line;
  const std::size_t size = rounded_up(std::max<std::size_t>(bytes, 1), alignment);
  void* memory = std::aligned_alloc(alignment, size);
  if (memory == nullptr) throw std::bad_alloc();

  // The call fails where the system has no large pages, or none left; small pages do as well.
  if (alignment == large_page) madvise(memory, size, MADV_HUGEPAGE);
  return memory;
}

void free_large(void* memory) noexcept { std::free(memory); }

}  // namespace pomona
