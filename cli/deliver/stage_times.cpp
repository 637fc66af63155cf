#include "cli/deliver/stage_times.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"

namespace pomona {

void StageTimes::diffused_by(const std::string& diffuser, const std::string& device) {
  diffuser_ = diffuser;
  device_ = device;
}

std::string StageTimes::json(int threads) const {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [stage, milliseconds] : clock_.stages()) stages[stage] = milliseconds;
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (const auto& [what, number] : counts_) counts[what] = number;
  nlohmann::ordered_json all = {{"stages", stages}, {"counts", counts}, {"threads", threads}};
  if (!diffuser_.empty()) {
    all["diffuser"] = diffuser_;
    all["device"] = device_;
  }
  return json_text(all, 2) + "\n";
}

std::string StageTimes::summary() const {
  std::string text;
  double total = 0;
  char buffer[96];
  for (const auto& [stage, milliseconds] : clock_.stages()) {
    std::snprintf(buffer, sizeof buffer, "%s %.0f ms, ", stage.c_str(), milliseconds);
    text += buffer;
    total += milliseconds;
  }
  std::snprintf(buffer, sizeof buffer, "together %.1f s", total / 1000);
  return text + buffer;
}

}  // namespace pomona
