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

/// The pieces at another ripeness.
struct RipenessVariant {
  std::string name;  ///< "ripeness 0.3"
  std::vector<Solid> pieces;
};

/// The variants for each ripeness that the order names.
/// \param pieces of the fruit at its own ripeness.
/// \param drawn the fruit's template.
/// \param diffuser null for whole fruit.
/// \param times the stages vary and sweep are added.
/// \throws Error (usage) for a file of surfaces, which has no template.
std::vector<RipenessVariant> ripeness_variants(std::span<const Solid> pieces, const OrderedFruit& fruit,
                                               const std::optional<Template>& drawn, const Order& order,
                                               const Diffuser* diffuser, StageClock& times);

}  // namespace pomona
