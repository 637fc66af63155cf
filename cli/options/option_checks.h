// What values an option takes, told in plain words when it is given another.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace pomona {

/// A number from `low` to `high`; "nan" is none. Help shows the limits as CLI11's own check does.
CLI::Validator between(double low, double high);

/// A whole number from `low` to `high`.
CLI::Validator whole_between(int low, int high);

/// One of these words; another one is answered with the nearest.
CLI::Validator one_of(const std::vector<std::string>& words);

}  // namespace pomona
