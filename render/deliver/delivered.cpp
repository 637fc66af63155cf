#include "render/deliver/delivered.h"

#include <iterator>
#include <utility>

namespace pomona {

void Delivered::add(const std::filesystem::path& path, const std::function<std::string()>& make) {
  files.push_back({.file = {path, times.time("write", make)}});
}

void Delivered::add(Delivered more) {
  files.insert(files.end(), std::make_move_iterator(more.files.begin()), std::make_move_iterator(more.files.end()));
  times.add(more.times);
  for (const auto& [what, number] : more.counts) counts[what] += number;
  warnings.insert(warnings.end(), more.warnings.begin(), more.warnings.end());
}

}  // namespace pomona
