// Arrays aligned for the processor's widest vector registers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

#include <hwy/aligned_allocator.h>

namespace pomona {

template <typename T>
using AlignedArray = hwy::AlignedFreeUniquePtr<T[]>;
using AlignedFloats = AlignedArray<float>;
using AlignedInts = AlignedArray<std::int32_t>;

/// Not initialised. Throws where Highway would return a null pointer for lack of memory.
/// \throws std::bad_alloc
template <typename T>
AlignedArray<T> aligned_array(std::size_t count) {
  AlignedArray<T> array = hwy::AllocateAligned<T>(count);
  if (array == nullptr) throw std::bad_alloc();
  return array;
}

}  // namespace pomona
