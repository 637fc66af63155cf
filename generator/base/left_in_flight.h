// For what cannot be taken apart once an exception has gone through it.
#pragma once

#include <exception>

namespace pomona {

/// Deletes for std::unique_ptr, except while an exception is in flight: CGAL's constrained triangulations do not hold
/// together after an allocation failed in the midst of an insertion, and their destructor would end the program.
template <typename T>
struct LeftInFlight {
  void operator()(T* object) const {
    if (std::uncaught_exceptions() == 0) delete object;
  }
};

}  // namespace pomona
