// The options of an order on the command line, all from the table (generator/order/option_table.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/order/option_table.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

/// The typed words of an order, before they are read.
struct TypedOrder {
  std::vector<std::pair<const OrderOption*, std::string>> words;  ///< each option with its text
  std::vector<std::string> outputs;                               ///< paths of -o
  std::string format;                                             ///< format of standard output, for an output "-"

  /// All texts that were typed for an option, such as the knives.
  std::vector<std::string> texts_of(const std::string& option) const;
};

/// Declares -o, --format, and every option of the table that `taker` has. `typed` and `table` must outlive the parsing.
/// \param writes what -o's help says: "What to write: .png".
void add_order_options(CLI::App& command, OrderTaker taker, const std::string& writes, TypedOrder& typed,
                       const std::vector<OrderOption>& table = order_options());

/// The order that the words give. Files that knives name are read.
/// \param formats that the command writes.
/// \throws Error (usage) for a text that is no value of its option, (cannot_create) as parse_outputs()
Order read_order(const TypedOrder& typed, const std::vector<Format>& formats);

}  // namespace pomona
