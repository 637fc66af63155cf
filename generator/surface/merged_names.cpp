#include "generator/surface/merged_names.h"

#include <algorithm>

namespace pomona {

std::vector<std::int32_t> merge_names(std::vector<std::string>& known, const std::vector<std::string>& names) {
  std::vector<std::int32_t> index;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    index.push_back(static_cast<std::int32_t>(found - known.begin()));
    if (found == known.end()) known.push_back(name);
  }
  return index;
}

}  // namespace pomona
