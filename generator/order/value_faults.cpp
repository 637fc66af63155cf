#include "generator/order/value_faults.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "generator/base/nearest_name.h"
#include "generator/base/units.h"

namespace pomona {

std::string limit_text(double number) {
  std::ostringstream text;
  text.precision(10);
  text << number;
  return text.str();
}

std::string joined_words(const std::vector<std::string>& words, const char* between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}

std::string range_fault(const std::string& text, double low, double high, bool whole) {
  const std::optional<double> value = parse_number(text);
  const bool fits = value && *value >= low && *value <= high;
  if (fits && (!whole || text.find_first_not_of("+-0123456789") == std::string::npos)) return {};
  return "\"" + text + "\" is not a " + (whole ? "whole " : "") + "number from " + limit_text(low) + " to " +
         limit_text(high);
}

std::string choice_fault(const std::string& text, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) return {};
  const std::optional<std::string> near = nearest_name(text, words);
  return "\"" + text + "\" is none of " + joined_words(words, ", ") + (near ? ": did you mean " + *near + "?" : "");
}

}  // namespace pomona
