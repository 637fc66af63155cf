// pomona pages: the manual page and the shells' completions, made from the options that are declared.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/options/option_checks.h"
#include "cli/pages/command_line.h"
#include "cli/pages/completion.h"
#include "cli/pages/manual_page.h"
#include "generator/base/json_text.h"
#include "generator/base/version.h"
#include "generator/batch/batch_file.h"
#include "generator/order/option_table.h"

namespace pomona {

namespace {

using OptionJson = nlohmann::ordered_json;

OptionJson range_json(const char* type, double low, double high) {
  return {{"type", type}, {"low", low}, {"high", high}};
}

OptionJson range_json(const char* type, int low, int high) { return {{"type", type}, {"low", low}, {"high", high}}; }

struct ValueJson {
  OptionJson operator()(const FlagValue&) const { return {{"type", "flag"}}; }
  OptionJson operator()(const WholeValue& v) const { return range_json("whole", v.low, v.high); }
  OptionJson operator()(const OptionalWholeValue& v) const { return range_json("whole", v.low, v.high); }
  OptionJson operator()(const NumberValue& v) const { return range_json("number", v.low, v.high); }
  OptionJson operator()(const OptionalNumberValue& v) const { return range_json("number", v.low, v.high); }
  OptionJson operator()(const CountValue&) const { return {{"type", "count"}}; }
  OptionJson operator()(const ChoiceValue& v) const { return {{"type", "choice"}, {"words", v.words}}; }
  OptionJson operator()(const TextValue&) const { return {{"type", "text"}}; }
  OptionJson operator()(const ParsedValue&) const { return {{"type", "text"}}; }
  OptionJson operator()(const KnivesValue&) const { return {{"type", "knives"}}; }
};

OptionJson takers_json(const OrderOption& option) {
  constexpr std::array names = {"grow", "cut", "plate", "scene", "batch"};
  OptionJson takers = OptionJson::array();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (has_option(static_cast<OrderTaker>(i), option)) takers.push_back(names[i]);
  return takers;
}

/// `pomona pages options`: an object for each option, in the order of the table.
std::string option_list() {
  const std::vector<const OrderOption*> of_batches = batch_options();
  OptionJson list = OptionJson::array();
  for (const OrderOption& option : order_options()) {
    OptionJson json = {{"name", option.name}, {"key", key_of(option)}};
    json.update(std::visit(ValueJson{}, option.value));
    if (!option.type.empty()) json["shown_type"] = option.type.substr(0, option.type.find(':'));
    if (!option.unit.empty()) json["unit"] = option.unit;
    json["usual"] = option.usual.empty() ? text_of_option(option, Order{}) : option.usual;
    json["commands"] = takers_json(option);
    json["formats"] = OptionJson::array();
    for (const Format format : option.heeded) json["formats"].push_back(name_of(format));
    json["batch_key"] = std::find(of_batches.begin(), of_batches.end(), &option) != of_batches.end();
    json["help"] = option.help;
    list.push_back(std::move(json));
  }
  return json_text(list, 1) + "\n";
}

std::string page(const std::string& kind, const std::vector<TypedCommand>& commands) {
  if (kind == "bash") return bash_completion(commands);
  if (kind == "zsh") return zsh_completion(commands);
  if (kind == "fish") return fish_completion(commands);
  if (kind == "options") return option_list();
  return manual_page(commands, version);
}

}  // namespace

DeclaredCommand pages_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("pages", "Print the manual page, what a shell completes, or the table of options");
  const auto kind = std::make_shared<std::string>();
  command->add_option("KIND", *kind, "What to print")
      ->required()
      ->check(one_of({"man", "bash", "zsh", "fish", "options"}));
  return {command, [kind, &app] {
            std::fputs(page(*kind, command_line(app)).c_str(), stdout);
            return ExitStatus::done;
          }};
}

}  // namespace pomona
