// Four floats at once: red, green, blue, and the chance that a walk from here ends on a surface at all.
#pragma once

#include <cstddef>
#include <memory>

namespace pomona {

/// A built-in vector of gcc and clang. The lanes never meet, so the bits are those of four plain floats.
using Quad = float __attribute__((vector_size(16)));

/// Memory that nobody has touched: whoever first writes a page, on whichever thread, brings it in.
template <typename T>
class RawArray {
 public:
  RawArray() = default;
  explicit RawArray(std::size_t size) : size_(size), data_(new T[size]) {}  // NOLINT: left uninitialised on purpose

  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<T[]> data_;
};

}  // namespace pomona
