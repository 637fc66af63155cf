// Options of an order in the records of batches.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/order/option_table.h"

namespace pomona {

/// The option's value in the order: a number, a boolean or a text.
nlohmann::ordered_json option_json(const OrderOption& option, const Order& order);

}  // namespace pomona
