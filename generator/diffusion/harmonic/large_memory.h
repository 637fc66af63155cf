// Memory for arrays of megabytes, in large pages where the system has them.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace pomona {

/// Uninitialised memory, aligned for any type. The first access to a page costs microseconds, however small the page
/// is. A grid's arrays would have thousands of pages of 4 KB, so large arrays ask for large pages. \throws
/// std::bad_alloc
void* allocate_large(std::size_t bytes);
void free_large(void* memory) noexcept;

/// An uninitialised array. The first thread that writes to a page makes the system provide it.
template <typename T>
class RawArray {
 public:
  RawArray() = default;
  explicit RawArray(std::size_t size) : size_(size), data_(static_cast<T*>(allocate_large(size * sizeof(T)))) {}
  RawArray(RawArray&& other) noexcept : size_(std::exchange(other.size_, 0)), data_(std::move(other.data_)) {}
  RawArray& operator=(RawArray&& other) noexcept {
    size_ = std::exchange(other.size_, 0);
    data_ = std::move(other.data_);
    return *this;
  }

  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }

 private:
  struct Free {
    void operator()(T* memory) const { free_large(memory); }
  };
  std::size_t size_ = 0;
  std::unique_ptr<T, Free> data_;
};

/// The same for std::vector.
template <typename T>
struct LargeAllocator {
  using value_type = T;  // NOLINT(readability-identifier-naming): the name that allocators have
  LargeAllocator() = default;
  template <typename U>
  LargeAllocator(const LargeAllocator<U>&) {}  // NOLINT(google-explicit-constructor): converts, as allocators do

  T* allocate(std::size_t size) {
    if (size > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_large(size * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t) { free_large(memory); }
  template <typename U>
  bool operator==(const LargeAllocator<U>&) const {
    return true;
  }
};

}  // namespace pomona
