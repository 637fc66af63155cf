#include "cli/batch/report.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/batch/tally.h"

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
  return json.dump(2);
}

std::string difference(const std::string& there, const std::string& wanted) {
  const auto old_one = nlohmann::json::parse(there, nullptr, false), new_one = nlohmann::json::parse(wanted);
  if (!old_one.is_object()) return "a batch.json that cannot be read";
  const auto told = [&](const char* key) { return old_one.value(key, nlohmann::json()).dump(); };
  const auto differs = [&](const char* key) { return old_one.value(key, nlohmann::json()) != new_one.at(key); };
  if (differs("name")) return "another batch, " + told("name");
  if (differs("program")) return "a batch of another version, " + told("program");
  if (differs("seed")) return "this batch with another seed, " + told("seed");
  if (differs("templates")) return "this batch with templates that have changed since";
  return "this batch as its file was before it was changed";
}

}  // namespace pomona
