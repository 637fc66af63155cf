// Options of an order as keys of batch and scene files.
#pragma once

#include "generator/order/option_table.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads the value at the option's key into the order, which stays if there is none. 0 means none for a whole number
/// whose range lies above. Mistakes are noted at their place in the file.
void read_option_key(const OrderOption& option, const TomlTable& table, Order& order);

/// The range of a number.
/// \throws Error (bug) for an option that is no number.
Within range_of(const OrderOption& option);

}  // namespace pomona
