#include "generator/order/option_key.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "generator/base/error.h"

namespace pomona {

namespace {

/// "0.3,1,1.7" of an array, or the text itself.
std::string joined_text(const TomlValue& value) {
  if (!value.is(TomlNode::Kind::array)) return value.text();
  std::ostringstream text;
  for (const TomlValue& number : value.values()) text << (text.tellp() > 0 ? "," : "") << number.number();
  return text.str();
}

struct ReadKey {
  const OrderOption& option;
  const TomlValue& value;
  Order& order;

  int whole(int low, int high) const {
    const int number = value.integer(0, std::min(low, 0), high);
    if (number != 0 && number < low)
      value.error("is below " + std::to_string(low) + (option.unit.empty() ? "" : " " + option.unit), "0 is none");
    return number;
  }
  void operator()(const FlagValue& v) const { v.in(order) = value.boolean(); }
  void operator()(const WholeValue& v) const { v.in(order) = whole(v.low, v.high); }
  void operator()(const OptionalWholeValue& v) const { v.in(order) = value.integer(v.low, v.low, v.high); }
  void operator()(const NumberValue& v) const { v.in(order) = value.number(v.in(order), {v.low, v.high}); }
  void operator()(const OptionalNumberValue& v) const { v.in(order) = value.number(v.low, {v.low, v.high}); }
  void operator()(const CountValue& v) const {
    v.in(order) = static_cast<std::uint64_t>(value.integer(0, 0, std::numeric_limits<int>::max()));
  }
  void operator()(const ChoiceValue& v) const { v.set(order, static_cast<std::size_t>(value.choice(v.words))); }
  void operator()(const TextValue& v) const { v.in(order) = value.text(); }
  void operator()(const ParsedValue& v) const {
    try {
      v.read(order, joined_text(value));
    } catch (const Error& error) {
      value.error("is no value of it: " + error.diagnostics().front().message, error.diagnostics().front().hint);
    }
  }
  void operator()(const KnivesValue&) const {}  // read_knives() knows where their files lie
};

}  // namespace

void read_option_key(const OrderOption& option, const TomlTable& table, Order& order) {
  const TomlValue value = table.get(key_of(option));
  if (value.given()) std::visit(ReadKey{option, value, order}, option.value);
}

Within range_of(const OrderOption& option) {
  if (const auto* number = std::get_if<NumberValue>(&option.value)) return {number->low, number->high};
  if (const auto* number = std::get_if<OptionalNumberValue>(&option.value)) return {number->low, number->high};
  if (const auto* number = std::get_if<WholeValue>(&option.value))
    return {static_cast<double>(number->low), static_cast<double>(number->high)};
  if (const auto* number = std::get_if<OptionalWholeValue>(&option.value))
    return {static_cast<double>(number->low), static_cast<double>(number->high)};
  throw Error(ExitStatus::bug, option.name + " is no number");
}

}  // namespace pomona
