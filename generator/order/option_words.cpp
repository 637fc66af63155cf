// Options of an order as texts: what is read from them, written as them, and told of them.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "generator/base/error.h"
#include "generator/base/number_text.h"
#include "generator/base/shell_words.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "generator/order/option_table.h"
#include "generator/order/value_faults.h"

namespace pomona {

namespace {

bool is_met(OptionNeed need, const Order& order) {
  switch (need) {
    case OptionNeed::nothing:
      return true;
    case OptionNeed::a_variant:
      return order.fruit.seed.value_or(0) != 0 || order.fruit.index || !order.fruit.seeds.empty();
    case OptionNeed::pieces:
      return !order.cut.section;
    case OptionNeed::textures:
      return wants_textures(order.mesh);
    case OptionNeed::ground_truth:
      return !order.picture.aov.empty();
  }
  return true;
}

/// The warning of an option whose need is not met.
const char* words_of(OptionNeed need) {
  switch (need) {
    case OptionNeed::a_variant:
      return "is about variants, and seed 0 is as drawn: --seed 1 is one";
    case OptionNeed::pieces:
      return "is about pieces: a section has none";
    case OptionNeed::textures:
      return "is about textures: --texture 1024 asks for them";
    case OptionNeed::ground_truth:
      return "is about --aov, which is not there";
    default:
      return "";
  }
}

std::optional<std::uint64_t> count_of(const std::string& text) {
  std::uint64_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

std::string empty_fault(const std::string& text) { return text.empty() ? "\"\" says nothing: leave it out" : ""; }

struct FaultOf {
  const std::string& text;
  std::string operator()(const FlagValue&) const { return choice_fault(text, {"true", "false"}); }
  std::string operator()(const WholeValue& v) const { return range_fault(text, v.low, v.high, true); }
  std::string operator()(const OptionalWholeValue& v) const { return range_fault(text, v.low, v.high, true); }
  std::string operator()(const NumberValue& v) const { return range_fault(text, v.low, v.high, false); }
  std::string operator()(const OptionalNumberValue& v) const { return range_fault(text, v.low, v.high, false); }
  std::string operator()(const CountValue&) const {
    return count_of(text) ? "" : "\"" + text + "\" is not a whole number from 0 to 18446744073709551615";
  }
  std::string operator()(const ChoiceValue& v) const { return choice_fault(text, v.words); }
  std::string operator()(const TextValue&) const { return empty_fault(text); }
  std::string operator()(const ParsedValue&) const { return empty_fault(text); }
  std::string operator()(const KnivesValue&) const { return empty_fault(text); }
};

/// Reads a text that has no fault.
struct Read {
  const std::string& text;
  Order& order;
  int whole() const { return static_cast<int>(*parse_number(text)); }
  void operator()(const FlagValue& v) const { v.in(order) = text == "true"; }
  void operator()(const WholeValue& v) const { v.in(order) = whole(); }
  void operator()(const OptionalWholeValue& v) const { v.in(order) = whole(); }
  void operator()(const NumberValue& v) const { v.in(order) = *parse_number(text); }
  void operator()(const OptionalNumberValue& v) const { v.in(order) = *parse_number(text); }
  void operator()(const CountValue& v) const { v.in(order) = count_of(text); }
  void operator()(const ChoiceValue& v) const {
    v.set(order, static_cast<std::size_t>(std::find(v.words.begin(), v.words.end(), text) - v.words.begin()));
  }
  void operator()(const TextValue& v) const { v.in(order) = text; }
  void operator()(const ParsedValue& v) const { v.read(order, text); }
  void operator()(const KnivesValue&) const { order.cut.knives.push_back(parse_knife(text)); }
};

struct TextOf {
  Order& order;  // not changed
  std::string operator()(const FlagValue& v) const { return v.in(order) ? "true" : ""; }
  std::string operator()(const WholeValue& v) const {
    const int number = v.in(order);
    return number < v.low ? "" : std::to_string(number);
  }
  std::string operator()(const OptionalWholeValue& v) const {
    return v.in(order) ? std::to_string(*v.in(order)) : std::string();
  }
  std::string operator()(const NumberValue& v) const {
    return v.in(order) < v.low ? std::string() : number_text(v.in(order));
  }
  std::string operator()(const OptionalNumberValue& v) const {
    return v.in(order) ? number_text(*v.in(order)) : std::string();
  }
  std::string operator()(const CountValue& v) const {
    return v.in(order) ? std::to_string(*v.in(order)) : std::string();
  }
  std::string operator()(const ChoiceValue& v) const {
    const std::optional<std::size_t> place = v.get(order);
    return place ? v.words[*place] : std::string();
  }
  std::string operator()(const TextValue& v) const { return v.in(order); }
  std::string operator()(const ParsedValue& v) const { return v.text(order); }
  std::string operator()(const KnivesValue&) const {
    std::string texts;
    for (const Knife& knife : order.cut.knives) texts += (texts.empty() ? "" : " ") + knife.text;
    return texts;
  }
};

}  // namespace

std::string fault_of_option(const OrderOption& option, const std::string& text) {
  return std::visit(FaultOf{text}, option.value);
}

void read_option(const OrderOption& option, const std::string& text, Order& order, bool none_is_zero) {
  const auto* whole = std::get_if<WholeValue>(&option.value);
  if (none_is_zero && whole != nullptr && whole->low > 0 && text == "0") return void(whole->in(order) = 0);
  const std::string fault = fault_of_option(option, text);
  if (!fault.empty()) throw Error(ExitStatus::usage, flag_of(option) + ": " + fault);
  std::visit(Read{text, order}, option.value);
}

std::string text_of_option(const OrderOption& option, const Order& order) {
  Order copy = order;
  return std::visit(TextOf{copy}, option.value);
}

bool is_ordered(const OrderOption& option, const Order& order, const Order& usual) {
  return text_of_option(option, order) != text_of_option(option, usual);
}

std::string piece_words(const Order& order, const std::vector<OrderOption>& table) {
  std::string words;
  for (const OrderOption& option : table) {
    if (!option.makes_piece || !is_ordered(option, order)) continue;
    if (option.need == OptionNeed::textures && !is_met(option.need, order)) continue;
    if (std::holds_alternative<KnivesValue>(option.value)) {
      for (const Knife& knife : order.cut.knives) words += " --knife " + shell_word(knife.text);
      continue;
    }
    words += " " + flag_of(option);
    if (!std::holds_alternative<FlagValue>(option.value)) words += " " + shell_word(text_of_option(option, order));
  }
  return words;
}

std::vector<std::string> idle_options(const Order& order, OrderTaker taker, const Order& usual,
                                      const std::vector<OrderOption>& table) {
  // Scenes and batches have seeds of their own.
  const bool has_own_seeds = taker == OrderTaker::scene || taker == OrderTaker::batch;
  std::vector<std::string> warnings;
  for (const OrderOption& option : table) {
    if (!has_option(taker, option) || !is_ordered(option, order, usual)) continue;
    if (!option.heeded.empty() && !any_is(order.outputs, option.heeded)) {
      warnings.push_back(flag_of(option) + " is about " + endings_of(option.heeded) + ": no output is one");
    } else if (!is_met(option.need, order) && !(has_own_seeds && option.need == OptionNeed::a_variant)) {
      warnings.push_back(flag_of(option) + " " + words_of(option.need));
    }
  }
  return warnings;
}

}  // namespace pomona
