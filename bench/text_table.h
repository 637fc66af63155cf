// Tables for terminals and documents: columns as wide as their longest entry.
#pragma once

#include <string>
#include <vector>

namespace pomona::bench {

struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< each with as many entries as the head
};

/// Lines of Markdown, aligned: they read well in a terminal and can be pasted into a document. The first column is
/// flush left, the others flush right.
std::string markdown(const TextTable& table);

/// "12.3"; "-" for what is not a number.
std::string number(double value, int decimals);

}  // namespace pomona::bench
