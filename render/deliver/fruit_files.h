// The files of fruit, whole or in pieces, as `pomona grow` and `pomona cut` write them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "generator/order/ordered_fruit.h"
#include "render/deliver/deliver_options.h"

namespace pomona {

/// The shells of the fruit, cavity walls included, with nothing inside; or all its surfaces as glass, if ordered.
/// Times and warnings go to `delivered`.
std::vector<Solid> whole_fruit(const OrderedFruit& fruit, const Order& order, Delivered& delivered);

/// One whole fruit: drawn surfaces go out as they are, pages and assets are made of them; all other outputs share one
/// scene. \param drawn its template, none of a surface file.
Delivered whole_fruit_files(const OrderedFruit& fruit, const std::optional<Template>& drawn, const Order& order,
                            const DeliverOptions& how);

/// Whole fruits of several seeds side by side; on a page all are cut by the same knives.
Delivered family_files(std::span<const OrderedFruit> family, const Order& order, const DeliverOptions& how);

/// The pieces of a fruit, where they grew; pages and assets are made of the fruit, and open with its knives.
/// \param diffuser that coloured the pieces.
Delivered cut_fruit_files(const Scene& pieces, const OrderedFruit& fruit, const std::optional<Template>& drawn,
                          const Diffuser& diffuser, const Order& order, const DeliverOptions& how);

}  // namespace pomona
