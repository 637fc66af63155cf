// Keyword arguments of Python as options of the table.
#pragma once

#include "generator/order/option_table.h"
#include "python/binding/python.h"

namespace pomona {

/// The order with these options, too. None says nothing. \param from the first step that is still to come: options of
/// earlier ones cannot be heeded any more.
/// \throws Error (usage) for values that an option does not take, and for options of steps that are over; TypeError for
/// keywords that are no options of this taker.
Order with_keywords(Order order, const py::dict& given, OrderTaker taker, OrderStep from);

/// Which of the options have no effect, whatever is written. \param order what was given.
std::vector<std::string> idle_growing(const Order& order, OrderTaker taker);

}  // namespace pomona
