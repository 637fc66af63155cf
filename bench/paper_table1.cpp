#include "bench/paper_table1.h"

namespace pomona::bench {

std::optional<PaperRow> paper_row(const std::string& template_name) {
  static constexpr PaperRow rows[] = {
      {"tomato", "N-fold", 6.1, 10619, 20412, 669},
      {"onion", "cylindrical", 1.9, 4184, 8110, 264},
      {"persimmon", "N-fold", 8.1, 9162, 18208, 584},
      {"pepper", "N-fold", 6.8, 9317, 18328, 592},
      {"avocado", "cylindrical", 0.8, 2699, 5341, 172},
      {"apple", "N-fold", 3.3, 4074, 7685, 255},
      {"okra", "N-fold", 3.7, 9400, 18480, 597},
      {"star_fruit", "N-fold", 3.2, 6357, 12190, 400},
      {"strawberry", "cylindrical", 7.7, 18158, 32049, 1110},
      {"cucumber", "N-fold", 7.9, 14984, 28592, 942},
      {"kiwi", "N-fold", 27.7, 21438, 38688, 1321},
      {"volcano", "cylindrical", 10.9, 11057, 20673, 690},
      {"kidney", "none", 3.9, 2939, 5694, 185},
  };
  for (const PaperRow& row : rows) {
    if (template_name == row.name) return row;
  }
  return std::nullopt;
}

}  // namespace pomona::bench
