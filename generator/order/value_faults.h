// Why a text is no value of an option: one answer for options of orders and for all others of the command line.
#pragma once

#include <string>
#include <vector>

namespace pomona {

/// A limit as help and messages write it: "0.05", "1000000".
std::string limit_text(double number);

/// The words with this between them: "a, b".
std::string joined_words(const std::vector<std::string>& words, const char* between);

/// Why the text is no number from `low` to `high`, or no whole one; empty if it is one. "nan" is none.
std::string range_fault(const std::string& text, double low, double high, bool whole);

/// Why the text is none of these words, with the nearest of them; empty if it is one.
std::string choice_fault(const std::string& text, const std::vector<std::string>& words);

}  // namespace pomona
