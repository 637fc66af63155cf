#include "cli/pages/command_line.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <CLI/CLI.hpp>

#include "generator/knife/knife_kinds.h"

namespace pomona {

namespace {

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

/// The text between two marks; empty without them.
std::string between(const std::string& text, char open, char close) {
  const std::size_t from = text.find(open), to = text.find(close, from);
  return from == std::string::npos || to == std::string::npos ? "" : text.substr(from + 1, to - from - 1);
}

/// The knives up to their colons: "half", "across", "plane:".
std::vector<std::string> knife_words() {
  std::vector<std::string> words;
  for (const KnifeKind& kind : knife_kinds()) words.push_back(kind.takes_value() ? kind.name + ":" : kind.name);
  return words;
}

TypedOption typed_option(const CLI::Option& declared) {
  TypedOption option;
  for (const std::string& name : declared.get_snames()) option.names.push_back("-" + name);
  for (const std::string& name : declared.get_lnames()) option.names.push_back("--" + name);
  option.help = declared.get_description();
  option.needed = declared.get_required();
  option.repeated = declared.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;

  // CLI11 writes the type and the check of a value as "TEXT:{draft,final}" or "INT:INT in [1 - 64]".
  if (declared.get_items_expected_max() == 0) return option;
  const std::string type = declared.get_type_name();
  option.value = option.names.empty() ? declared.get_name(true) : type.substr(0, type.find(':'));
  option.limits = between(type, '[', ']');
  option.usual = declared.get_default_str();
  if (const std::string words = between(type, '{', '}'); !words.empty()) option.words = split_at_commas(words);
  if (option.value == "KNIFE") option.words = knife_words();
  return option;
}

TypedCommand typed_command(const CLI::App& app, const std::string& before = "") {
  TypedCommand command{before + app.get_name(), app.get_description(), {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options()) command.options.push_back(typed_option(*option));
  return command;
}

}  // namespace

std::vector<TypedCommand> command_line(const CLI::App& app) {
  std::vector<TypedCommand> commands = {typed_command(app)};
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::size_t whole = commands.size();
    commands.push_back(typed_command(*command));
    for (const CLI::App* part : command->get_subcommands({})) {
      commands[whole].parts.push_back(part->get_name());
      commands.push_back(typed_command(*part, command->get_name() + " "));
    }
  }
  return commands;
}

bool is_part(const TypedCommand& command) { return command.name.find(' ') != std::string::npos; }

bool takes_files(const TypedOption& option) {
  static constexpr std::array kinds = {"FILE",      "TEMPLATE", "SCENE", "BATCH", "STYLE",
                                       "REFERENCE", "RESULT",   "KNIFE", "FOLDER"};
  return std::find(kinds.begin(), kinds.end(), option.value) != kinds.end();
}

}  // namespace pomona
