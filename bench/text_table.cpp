#include "bench/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pomona::bench {

std::string markdown(const TextTable& table) {
  // The width of each column.
  std::vector<std::size_t> width;
  for (const std::string& name : table.head) width.push_back(std::max<std::size_t>(name.size(), 3));
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }

  std::string text;
  const auto add_row = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(width[i] - row[i].size(), ' ');
      text += "| " + (i == 0 ? row[i] + space : space + row[i]) + ' ';
    }
    text += "|\n";
  };
  add_row(table.head);
  for (std::size_t i = 0; i < width.size(); ++i) {
    text += i == 0 ? "|" + std::string(width[i] + 2, '-') : "|" + std::string(width[i] + 1, '-') + ":";
  }
  text += "|\n";
  for (const auto& row : table.rows) add_row(row);
  return text;
}

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace pomona::bench
