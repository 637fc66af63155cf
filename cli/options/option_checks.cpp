#include "cli/options/option_checks.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "generator/base/nearest_name.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// As few figures as say it: 0.1, 64.
std::string written(double number) {
  std::ostringstream text;
  text.precision(10);
  text << number;
  return text.str();
}

/// \param type what CLI11 calls such a value.
CLI::Validator limits(double low, double high, bool whole, const std::string& type) {
  const auto fault = [=](std::string& text) -> std::string {
    const std::optional<double> value = parse_number(text);
    const bool fits = value && *value >= low && *value <= high;
    if (fits && (!whole || text.find_first_not_of("+-0123456789") == std::string::npos)) return {};
    return "\"" + text + "\" is not a " + (whole ? "whole " : "") + "number from " + written(low) + " to " +
           written(high);
  };
  return CLI::Validator(fault, type + " in [" + written(low) + " - " + written(high) + "]");
}

}  // namespace

CLI::Validator between(double low, double high) { return limits(low, high, false, "FLOAT"); }

CLI::Validator whole_between(int low, int high) { return limits(low, high, true, "INT"); }

CLI::Validator one_of(const std::vector<std::string>& words) {
  std::string shown;
  for (const std::string& word : words) shown += (shown.empty() ? "" : ",") + word;
  const auto fault = [words](std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    std::string known;
    for (const std::string& word : words) known += (known.empty() ? "" : ", ") + word;
    const std::optional<std::string> near = nearest_name(text, words);
    return "\"" + text + "\" is none of " + known + (near ? ": did you mean " + *near + "?" : "");
  };
  return CLI::Validator(fault, "{" + shown + "}");
}

}  // namespace pomona
