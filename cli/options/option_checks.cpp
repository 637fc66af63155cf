#include "cli/options/option_checks.h"

#include "generator/order/value_faults.h"

namespace pomona {

namespace {

/// \param type CLI11's name of such values.
CLI::Validator limits(double low, double high, bool whole, const char* type) {
  return CLI::Validator([=](std::string& text) { return range_fault(text, low, high, whole); },
                        limits_text(type, low, high));
}

}  // namespace

std::string limits_text(const char* type, double low, double high) {
  return std::string(type) + " in [" + limit_text(low) + " - " + limit_text(high) + "]";
}

std::string choice_text(const std::vector<std::string>& words) { return "{" + joined_words(words, ",") + "}"; }

CLI::Validator between(double low, double high) { return limits(low, high, false, "FLOAT"); }

CLI::Validator whole_between(int low, int high) { return limits(low, high, true, "INT"); }

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::Validator([words](std::string& text) { return choice_fault(text, words); }, choice_text(words));
}

CLI::Validator folder_name() {
  return CLI::Validator([](std::string& text) { return std::string(text.empty() ? "\"\" names no folder" : ""); }, "");
}

}  // namespace pomona
