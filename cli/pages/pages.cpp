// pomona pages: the manual page and the shells' completions, made from the options that are declared.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/options/option_checks.h"
#include "cli/pages/command_line.h"
#include "cli/pages/completion.h"
#include "cli/pages/manual_page.h"
#include "cli/pages/option_list.h"
#include "generator/base/version.h"

namespace pomona {

namespace {

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
