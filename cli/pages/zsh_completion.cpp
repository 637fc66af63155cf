#include "cli/pages/completion.h"
#include "cli/pages/names_asked_for.h"

namespace pomona {

namespace {

/// Escapes a text for '...', and brackets and colons for zsh's specifications.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// ":FILE:_files": the kind of a value, and its completion.
std::string action(const TypedOption& option) {
  const std::string what = ":" + quoted(option.value) + ":";
  if (option.value == "KNIFE") return what + "_pomona_knives";
  if (!names_asked_for(option.value).empty()) return what + "_pomona_" + option.value;
  if (takes_files(option)) return what + "_files";
  std::string words;
  for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + word;
  return what + (words.empty() ? " " : "(" + words + ")");
}

/// The arguments of _arguments, one per line.
std::string specifications(const TypedCommand& command) {
  std::string text;
  for (const TypedOption& option : command.options) {
    if (option.names.empty()) text += " \\\n        '" + std::string(option.repeated ? "*" : "") + action(option) + "'";
    for (const std::string& name : option.names) {
      text += " \\\n        '" + std::string(option.repeated ? "*" : "") + name + "[" + quoted(option.help) + "]" +
              (option.value.empty() ? "" : action(option)) + "'";
    }
  }
  return text;
}

/// A function that completes names, and files as well.
std::string names_function(const std::string& value) {
  return "_pomona_" + value + "() {\n  local -a names\n  names=(${(f)\"$(" + names_asked_for(value) +
         ")\"})\n  _alternative \"names:" + value + ":($names)\" 'files:file:_files'\n}\n";
}

/// Knives continue after their colon.
std::string knives_function(std::span<const TypedCommand> commands) {
  std::string words;
  for (const TypedCommand& command : commands) {
    for (const TypedOption& option : command.options) {
      if (option.value != "KNIFE" || !words.empty()) continue;
      for (const std::string& word : option.words) words += " " + word;
    }
  }
  return "_pomona_knives() {\n  compadd -S '' --" + words + "\n}\n";
}

/// A command with subcommands: the subcommand, then its words.
std::string parts_of(const TypedCommand& whole, std::span<const TypedCommand> commands) {
  std::string text = "_arguments -C '1:command:(", names;
  for (const std::string& part : whole.parts) names += (names.empty() ? "" : " ") + part;
  text += names + ")' '*:: :->part'\n      [[ $state == part ]] && case $words[1] in\n";
  for (const TypedCommand& command : commands) {
    if (!command.name.starts_with(whole.name + " ")) continue;
    text +=
        "        " + command.name.substr(whole.name.size() + 1) + ") _arguments" + specifications(command) + " ;;\n";
  }
  return text + "      esac";
}

}  // namespace

std::string zsh_completion(std::span<const TypedCommand> commands) {
  std::string text = "#compdef pomona\n# Made from the program's options by `pomona pages zsh`.\n";
  for (const char* value : {"TEMPLATE", "SCENE", "BATCH", "STYLE"}) text += names_function(value);
  text += knives_function(commands);

  text += "_pomona() {\n  local context state line\n  typeset -A opt_args\n  _arguments -C" +
          specifications(commands.front()) + " \\\n        '1: :->command' '*:: :->rest'\n";
  text += "  if [[ $state == command ]]; then\n    local -a commands\n    commands=(";
  for (const TypedCommand& command : commands.subspan(1)) {
    if (is_part(command)) continue;
    text += "\n      '" + command.name + ":" + quoted(command.help) + "'";
  }
  text += ")\n    _describe command commands\n    return\n  fi\n  case $words[1] in\n";
  for (const TypedCommand& command : commands.subspan(1)) {
    if (is_part(command)) continue;
    const bool of_parts = !command.parts.empty();
    text += "    " + command.name + ") " +
            (of_parts ? parts_of(command, commands) : "_arguments" + specifications(command)) + " ;;\n";
  }
  return text + "  esac\n}\nif [[ $funcstack[1] == _pomona ]]; then _pomona \"$@\"; else compdef _pomona pomona; fi\n";
}

}  // namespace pomona
