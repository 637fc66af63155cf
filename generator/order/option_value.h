// How an option's value is read and where in an order it lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/order/order.h"

namespace pomona {

/// A switch.
struct FlagValue {
  bool& (*in)(Order&);
};

/// A whole number of a range.
struct WholeValue {
  int& (*in)(Order&);
  int low = 0, high = 0;
};

/// A whole number of a range, or none.
struct OptionalWholeValue {
  std::optional<int>& (*in)(Order&);
  int low = 0, high = 0;
};

/// A number of a range.
struct NumberValue {
  double& (*in)(Order&);
  double low = 0, high = 0;
};

/// A number of a range, or none.
struct OptionalNumberValue {
  std::optional<double>& (*in)(Order&);
  double low = 0, high = 0;
};

/// A whole number of 64 bits.
struct CountValue {
  std::optional<std::uint64_t>& (*in)(Order&);
};

/// One of a few words, each an enumerator.
struct ChoiceValue {
  std::vector<std::string> words;
  std::optional<std::size_t> (*get)(const Order&);  ///< its index in `words`; nothing if the order says nothing
  void (*set)(Order&, std::size_t);
};

/// Any text that is not empty: names and paths.
struct TextValue {
  std::string& (*in)(Order&);
};

/// A text with rules of its own. `read` throws Error (usage); `text` gives back what it read, "" for nothing.
struct ParsedValue {
  void (*read)(Order&, const std::string&);
  std::string (*text)(const Order&);
};

/// Knives: the option may be given several times.
struct KnivesValue {};

using OptionValue = std::variant<FlagValue, WholeValue, OptionalWholeValue, NumberValue, OptionalNumberValue,
                                 CountValue, ChoiceValue, TextValue, ParsedValue, KnivesValue>;

}  // namespace pomona
