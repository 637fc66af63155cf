#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/version.h"
#include "generator/base/nearest_name.h"

namespace pomona {

namespace {

bool colors_wanted() { return isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr; }

/// "error:" in red on a terminal, unless NO_COLOR says otherwise.
void print_error(std::string text) {
  const std::string word = "error:";
  const std::size_t at = text.find(word);
  if (colors_wanted() && at != std::string::npos) text.replace(at, word.size(), "\033[1;31merror:\033[0m");
  std::fprintf(stderr, "%s\n", text.c_str());
}

void print(const Error& error) {
  for (const Diagnostic& diagnostic : error.diagnostics()) print_error(to_string(diagnostic));
}

/// The names of all options a subcommand knows, for "did you mean".
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// What to say after a parse error: the nearest option for a mistyped one, and where help is.
std::string hint_for(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* asked = &app;
  std::string words = "pomona";
  while (!asked->get_subcommands().empty()) {
    asked = asked->get_subcommands().back();
    words += " " + asked->get_name();
  }
  std::string hint;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> known = option_names(*asked);
    for (int i = 1; i < argc; ++i) {
      const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
      if (!word.starts_with("--") || std::find(known.begin(), known.end(), word) != known.end()) continue;
      if (const auto near = nearest_name(word, known)) hint = "did you mean " + *near + "? ";
    }
  }
  return hint + "see `" + words + " -h`";
}

/// A first word that is no command is told as such; CLI11 only says that a subcommand is missing.
std::optional<std::string> unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return std::nullopt;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), argv[1]) != known.end()) return std::nullopt;
  const auto near = nearest_name(argv[1], known);
  return std::string("error: there is no command \"") + argv[1] +
         "\"\n  hint: " + (near ? "did you mean " + *near + "?" : "see `pomona -h`");
}

ExitStatus run_action(const std::function<ExitStatus()>& action) {
  try {
    return action();
  } catch (const Error& error) {
    print(error);
    return error.status();
  } catch (const std::bad_alloc&) {
    print_error("error: out of memory\n  hint: a smaller --detail or --size needs less");
  } catch (const std::exception& error) {
    print_error(std::string("error: this is a bug in pomona: ") + error.what());
  }
  return ExitStatus::bug;
}

}  // namespace

int run(const std::vector<Command>& commands, int argc, char** argv) {
  CLI::App app("Grows fruit and vegetables that can be cut anywhere, and fills scenes with them.", "pomona");
  app.set_version_flag("--version", std::string("pomona ") + version);
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  std::vector<DeclaredCommand> declared;
  for (const Command command : commands) declared.push_back(command(app));

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_text) {
    return app.exit(asked_for_text);  // -h or --version
  } catch (const CLI::ParseError& error) {
    const auto unknown = unknown_command(app, argc, argv);
    print_error(unknown ? *unknown
                        : std::string("error: ") + error.what() + "\n  hint: " + hint_for(app, error, argc, argv));
    return static_cast<int>(ExitStatus::usage);
  }
  for (const DeclaredCommand& command : declared) {
    if (command.subcommand->parsed()) return static_cast<int>(run_action(command.action));
  }
  return static_cast<int>(ExitStatus::usage);
}

}  // namespace pomona
