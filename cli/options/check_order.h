// Refuses impossible orders before the work begins; options without an effect are warnings (idle_options()).
#pragma once

#include "cli/options/telling.h"
#include "generator/order/option_table.h"

namespace pomona {

/// \throws Error (usage) for options that contradict each other or are impossible, and for two files of one name;
/// (cannot_create) for a folder that does not exist or cannot be written to.
void check_order(const Order& order, OrderTaker taker, const Telling& telling);

}  // namespace pomona
