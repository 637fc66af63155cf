// Options of an order as keys of TOML files: batches and scenes.
#pragma once

#include "generator/order/option_table.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Puts the value at the option's key into the order; what stood there before stays where no value is given. Of a whole
/// number whose range lies above it, 0 means none. Mistakes are noted at their place in the file.
void read_option_key(const OrderOption& option, const TomlTable& table, Order& order);

/// The values that a number may have. \throws Error (bug) for an option that is no number.
Within range_of(const OrderOption& option);

}  // namespace pomona
