// Grows the fruit of a name or a path on the command line to order.
#pragma once

#include <optional>
#include <string>

#include "generator/order/ordered_fruit.h"

namespace pomona {

struct NamedFruit {
  OrderedFruit grown;
  std::optional<Template> drawn = {};  ///< nothing for a surface file
};

/// Reads, varies and sweeps; a path that ends in .ply is read as surfaces.
/// \param word a name from `pomona list`, or a path.
/// \throws Error (input_missing), and as read_template(), read_surfaces(), grow()
NamedFruit open_fruit(const std::string& word, const Order& order);

}  // namespace pomona
