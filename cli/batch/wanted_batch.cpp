#include "cli/batch/wanted_batch.h"

#include <nlohmann/json.hpp>

#include "cli/file_kind.h"
#include "cli/find_template.h"
#include "cli/version.h"
#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/batch/batch_record.h"

namespace pomona {

namespace {

/// In what the batch that a folder holds differs from the one wanted, both as batch.json: `another batch, "small"`.
std::string difference(const std::string& there, const std::string& wanted) {
  const auto old_one = nlohmann::json::parse(there, nullptr, false), new_one = nlohmann::json::parse(wanted);
  if (!old_one.is_object()) return "a batch.json that cannot be read";
  const auto told = [&](const char* key) { return json_text(old_one.value(key, nlohmann::json())); };
  const auto differs = [&](const char* key) { return old_one.value(key, nlohmann::json()) != new_one.at(key); };
  if (differs("name")) return "another batch, " + told("name");
  if (differs("program")) return "a batch of another version, " + told("program");
  if (differs("seed")) return "this batch with another seed, " + told("seed");
  if (differs("templates")) return "this batch with templates that have changed since";
  return "this batch as its file was before it was changed";
}

}  // namespace

BatchPlan wanted_batch(const std::filesystem::path& file) {
  check_kind(file, FileKind::batch);
  return planned(read_batch(file), {.find = find_template, .all = all_templates});
}

std::string record_of(const BatchPlan& plan) { return batch_record(plan, std::string("pomona ") + version); }

void check_holds_no_other(const std::filesystem::path& folder, const std::string& there, const std::string& wanted) {
  if (there.empty() || there == wanted) return;
  throw Error(
      ExitStatus::cannot_create,
      {{{folder.string(), 0, 0, {}}, "holds " + difference(there, wanted), "name another folder, or remove this one"}});
}

}  // namespace pomona
