// What can be typed, read off the declared options: the one source of the manual page and of what shells complete.
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct TypedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; none for a word that is known by its place
  std::string value;               ///< what follows: "FILE", "INT"; or what the word is: "TEMPLATE". None for a flag
  std::vector<std::string> words;  ///< all it may be, where they are few; a word that ends in ':' goes on
  std::string limits;              ///< "1 - 64", for numbers
  std::string usual;               ///< what it is if nobody says so
  std::string help;
  bool needed = false;
  bool repeated = false;
};

struct TypedCommand {
  std::string name;  ///< "cut"; of a command within another, both: "farm slurm"
  std::string help;
  std::vector<TypedOption> options;
  std::string more;                     ///< what its help ends with, line by line: the knives
  std::vector<std::string> parts = {};  ///< last words of the commands within it, one of which must follow
};

/// The program itself, whose options stand before any command, and after it the commands, each before those within it.
std::vector<TypedCommand> command_line(const CLI::App& app);

/// Whether it stands within another: its name has two words.
bool is_part(const TypedCommand& command);

/// Whether the name of an existing or new file may follow.
bool takes_files(const TypedOption& option);

}  // namespace pomona
