// Arrays of numpy that show what lies in vectors: nothing is copied, nobody can write, and what they show lives as long
// as they do.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "python/binding/python.h"

namespace pomona {

/// Keeps alive what is seen.
using ViewOwner = std::shared_ptr<const void>;

inline py::capsule kept(ViewOwner owner) {
  return py::capsule(new ViewOwner(std::move(owner)), [](void* held) { delete static_cast<ViewOwner*>(held); });
}

/// A view of this shape, row by row.
template <typename Number>
py::array view_of(const Number* numbers, std::vector<py::ssize_t> shape, const ViewOwner& owner) {
  py::array_t<Number> array(std::move(shape), numbers, kept(owner));
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// One row an element: n x 3 of glm::vec3.
template <typename Number, typename Element>
py::array rows_of(const std::vector<Element>& elements, const ViewOwner& owner) {
  constexpr auto columns = static_cast<py::ssize_t>(sizeof(Element) / sizeof(Number));
  static_assert(sizeof(Element) % sizeof(Number) == 0);
  return view_of(reinterpret_cast<const Number*>(elements.data()), {std::ssize(elements), columns}, owner);
}

template <typename Number>
py::array numbers_of(const std::vector<Number>& numbers, const ViewOwner& owner) {
  return view_of(numbers.data(), {std::ssize(numbers)}, owner);
}

}  // namespace pomona
