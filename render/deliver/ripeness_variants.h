// A cut fruit at several ripenesses, on one mesh: --ripeness-variants.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/base/stage_clock.h"
#include "generator/diffusion/diffuser.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {

/// The pieces once more, at another ripeness.
struct RipenessVariant {
  std::string name;  ///< "ripeness 0.3"
  std::vector<Solid> pieces;
};

/// At each ripeness that the order names. \param pieces of the fruit as it is. \param drawn the fruit's template.
/// \param diffuser none for what was not cut. \param times grows by the stages vary and sweep.
/// \throws Error (usage) where there is no template, but a file of surfaces.
std::vector<RipenessVariant> ripeness_variants(std::span<const Solid> pieces, const OrderedFruit& fruit,
                                               const std::optional<Template>& drawn, const Order& order,
                                               const Diffuser* diffuser, StageClock& times);

}  // namespace pomona
