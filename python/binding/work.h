// Long work, as Python sees it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "python/binding/python.h"
#include "render/deliver/delivered.h"

namespace pomona {

/// What work is given to tell.
struct Telltale {
  DeliveryProgress progress;          ///< stops the work, too, where that was asked for
  std::vector<std::string> warnings;  ///< told when the work is done
};

/// Does the work on a thread of its own, without Python's lock. The calling thread meanwhile calls `progress` with a
/// stage, how much is done, and of how much; and it hears Ctrl-C, which stops the work at its next item. What the work
/// throws, or `progress`, is thrown here, when the work has ended. Its warnings become Python's.
/// \param progress None, or what can be called.
void run_work(const py::object& progress, const std::function<void(Telltale&)>& work);

}  // namespace pomona
