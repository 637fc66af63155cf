#include "generator/batch/option_json.h"

#include <nlohmann/json.hpp>

#include "generator/base/units.h"

namespace pomona {

nlohmann::ordered_json option_json(const OrderOption& option, const Order& order) {
  const std::string text = text_of_option(option, order);
  if (std::holds_alternative<FlagValue>(option.value)) return text == "true";
  if (std::holds_alternative<WholeValue>(option.value)) return std::stoi(text);
  if (std::holds_alternative<NumberValue>(option.value)) return parse_number(text).value();
  return text;
}

}  // namespace pomona
