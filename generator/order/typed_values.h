// Values of options that have a spelling of their own: sizes of pictures, views, lists of seeds.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "generator/order/option_value.h"

namespace pomona {

/// "1-5" or "0,2,7": 1 to 64 seeds.
/// \throws Error (usage) for anything else.
void read_seeds(Order& order, const std::string& text);
std::string seeds_text(const Order& order);

/// "0.2mm", a length above 0.
/// \throws Error (usage)
void read_texel(Order& order, const std::string& text);

/// "0.3,1,1.7": up to 16 numbers from 0 to 2, none twice.
/// \throws Error (usage)
void read_ripeness_variants(Order& order, const std::string& text);
std::string ripeness_variants_text(const Order& order);

/// "800x600", "120x90mm".
/// \throws Error (usage) for other texts.
void read_picture_extent(Order& order, const std::string& text);

/// "front", "back", "left", "right", "top", "bottom", "three-quarter", or "AZIMUTH,ELEVATION" in degrees (azimuth from
/// +Z, the front, towards +X).
/// \throws Error (usage)
void read_viewpoint(Order& order, const std::string& text);

/// "VIEW:{front,back,...}": what help calls a view; the words in braces are what shells complete.
std::string view_type();

/// The member of an order at a path of members: member_of<&Order::cut, &CutOrder::piece>(order) is order.cut.piece.
template <auto First, auto... Rest>
auto& member_of(auto& whole) {
  if constexpr (sizeof...(Rest) == 0) {
    return whole.*First;
  } else {
    return member_of<Rest...>(whole.*First);
  }
}

/// Words for the enumerators 0, 1, ... of a member at this path, which is an enumeration or an optional one.
template <auto... Path>
ChoiceValue choice_value(std::vector<std::string> words) {
  using Member = std::remove_reference_t<decltype(member_of<Path...>(std::declval<Order&>()))>;
  if constexpr (std::is_enum_v<Member>) {
    return {std::move(words),
            [](const Order& order) { return std::optional(static_cast<std::size_t>(member_of<Path...>(order))); },
            [](Order& order, std::size_t place) { member_of<Path...>(order) = static_cast<Member>(place); }};
  } else {
    return {std::move(words),
            [](const Order& order) {
              const Member& value = member_of<Path...>(order);
              return value ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
            },
            [](Order& order, std::size_t place) {
              member_of<Path...>(order) = static_cast<typename Member::value_type>(place);
            }};
  }
}

}  // namespace pomona
