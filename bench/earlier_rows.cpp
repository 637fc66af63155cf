#include "bench/earlier_rows.h"

#include <fstream>

#include "generator/base/error.h"

namespace pomona::bench {

std::vector<nlohmann::ordered_json> earlier_rows(const std::filesystem::path& report) {
  std::ifstream stream(report);
  if (!stream) return {};
  const auto rows = nlohmann::ordered_json::parse(stream, nullptr, false);
  if (!rows.is_array()) {
    throw Error(ExitStatus::bad_data, report.string() + " is not a report that this program has written");
  }
  return rows.get<std::vector<nlohmann::ordered_json>>();
}

}  // namespace pomona::bench
