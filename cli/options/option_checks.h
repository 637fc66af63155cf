// Checks of the values of options, with messages in plain words.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace pomona {

/// "INT in [0 - 9]", as CLI11's help writes limits; cli/pages/command_line.cpp parses it.
std::string limits_text(const char* type, double low, double high);

/// "{a,b}", as CLI11's help writes a choice.
std::string choice_text(const std::vector<std::string>& words);

/// A number from `low` to `high`, not "nan". Help shows the limits like CLI11's own check.
CLI::Validator between(double low, double high);

/// A whole number from `low` to `high`.
CLI::Validator whole_between(int low, int high);

/// One of these words; a message for another one suggests the nearest.
CLI::Validator one_of(const std::vector<std::string>& words);

/// The name of a folder, which is not empty.
CLI::Validator folder_name();

}  // namespace pomona
