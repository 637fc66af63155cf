#include "cli/options/order_options.h"

#include <variant>

#include <CLI/CLI.hpp>

#include "cli/deliver/outputs.h"
#include "cli/options/option_checks.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

/// How CLI11's help names the type of a value and its possible values; cli/pages/command_line.cpp parses it.
struct TypeText {
  std::string type, limits;
};

struct TypeOf {
  const OrderOption& option;
  TypeText operator()(const FlagValue&) const { return {}; }
  TypeText operator()(const WholeValue& v) const { return {"INT", limits_text("INT", v.low, v.high)}; }
  TypeText operator()(const OptionalWholeValue& v) const { return {"INT", limits_text("INT", v.low, v.high)}; }
  TypeText operator()(const NumberValue& v) const { return {"FLOAT", limits_text("FLOAT", v.low, v.high)}; }
  TypeText operator()(const OptionalNumberValue& v) const { return {"FLOAT", limits_text("FLOAT", v.low, v.high)}; }
  TypeText operator()(const CountValue&) const { return {"UINT", ""}; }
  TypeText operator()(const ChoiceValue& v) const { return {"TEXT", choice_text(v.words)}; }
  TypeText operator()(const TextValue&) const { return {option.type, ""}; }
  TypeText operator()(const ParsedValue&) const { return {option.type, ""}; }
  TypeText operator()(const KnivesValue&) const { return {option.type, ""}; }
};

void add_order_option(CLI::App& command, const OrderOption& option, TypedOrder& typed) {
  const OrderOption* const row = &option;
  if (std::holds_alternative<FlagValue>(option.value)) {
    command.add_flag_callback(
        flag_of(option), [row, &typed] { typed.words.emplace_back(row, "true"); }, option.help);
    return;
  }
  const auto take = [row, &typed](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) typed.words.emplace_back(row, text);
  };
  const TypeText type = std::visit(TypeOf{option}, option.value);
  CLI::Option* const declared =
      command.add_option_function<std::vector<std::string>>(flag_of(option), take, option.help);
  declared->expected(1)->allow_extra_args(false)->type_name(type.type);
  declared->check(CLI::Validator([row](std::string& text) { return fault_of_option(*row, text); }, type.limits));
  if (std::holds_alternative<KnivesValue>(option.value)) {
    declared->required()->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  } else {
    declared->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  }
  const std::string usual = option.usual.empty() ? text_of_option(option, Order{}) : option.usual;
  if (!usual.empty()) declared->default_str(usual);
  if (!option.excludes.empty()) declared->excludes(command.get_option("--" + option.excludes));
}

}  // namespace

std::vector<std::string> TypedOrder::texts_of(const std::string& option) const {
  std::vector<std::string> texts;
  for (const auto& [row, text] : words)
    if (row->name == option) texts.push_back(text);
  return texts;
}

void add_order_options(CLI::App& command, OrderTaker taker, const std::string& writes, TypedOrder& typed,
                       const std::vector<OrderOption>& table) {
  command.add_option("-o,--output", typed.outputs, writes)
      ->type_name("FILE")
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--format", typed.format, "What -o - writes to standard output: an ending without its dot")
      ->type_name("FORMAT");
  for (const OrderOption& option : table) {
    if (has_option(taker, option)) add_order_option(command, option, typed);
  }
}

Order read_order(const TypedOrder& typed, const std::vector<Format>& formats) {
  Order order;
  for (const auto& [option, text] : typed.words) read_option(*option, text, order);
  order.outputs = parse_outputs(typed.outputs, formats, typed.format);
  return order;
}

}  // namespace pomona
