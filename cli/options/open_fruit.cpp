#include "cli/options/open_fruit.h"

#include <utility>

#include "cli/options/file_kind.h"
#include "cli/options/find_template.h"
#include "generator/base/small_ending.h"
#include "generator/template/read/read_template.h"

namespace pomona {

NamedFruit open_fruit(const std::string& word, const Order& order) {
  const std::filesystem::path file = find_template(word);
  check_kind(file, FileKind::fruit);
  if (small_ending(file) == ".ply") return {fruit_of_surfaces(file, order), {}};
  StageClock times;
  Template drawn = times.time("read", [&] { return read_template(file); });
  OrderedFruit grown = ordered_fruit(drawn, file.stem().string(), word, order);
  times.add(grown.times);
  grown.times = std::move(times);
  return {std::move(grown), std::move(drawn)};
}

}  // namespace pomona
