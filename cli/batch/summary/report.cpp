#include "cli/batch/summary/report.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/batch/summary/tally.h"
#include "generator/base/json_text.h"

namespace pomona {

std::string summary(const RunReport& report, const std::string& folder) {
  const Tally& tally = report.tally;
  char rate[32];
  std::snprintf(rate, sizeof rate, "%.1f", tally.per_second());
  std::string text = folder + ": made " + std::to_string(tally.made) + " items in " + duration_text(tally.seconds) +
                     " (" + rate + " a second)";
  if (tally.found > 0) text += ", " + std::to_string(tally.found) + " were there";
  if (tally.failed > 0) text += ", " + std::to_string(tally.failed) + " failed";
  return text;
}

std::string report_as_json(const RunReport& report) {
  nlohmann::ordered_json json = {{"items", report.tally.total},
                                 {"found", report.tally.found},
                                 {"made", report.tally.made},
                                 {"failed", nlohmann::ordered_json::array()},
                                 {"seconds", report.tally.seconds}};
  for (const FailedItem& failed : report.failed)
    json["failed"].push_back({{"item", failed.item}, {"reason", failed.reason}});
  return json_text(json, 2);
}

}  // namespace pomona
