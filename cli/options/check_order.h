// What cannot be done of an order, told before the work begins; what merely has no effect is a warning
// (idle_options()).
#pragma once

#include "cli/options/telling.h"
#include "generator/order/option_table.h"

namespace pomona {

/// \throws Error (usage) for options that contradict each other or ask for what cannot be, and for two files of one
/// name; (cannot_create) for a folder that is not there or cannot be written to.
void check_order(const Order& order, OrderTaker taker, const Telling& telling);

}  // namespace pomona
