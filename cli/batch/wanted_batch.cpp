#include "cli/batch/wanted_batch.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/options/file_kind.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "generator/base/beside.h"
#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/version.h"
#include "generator/batch/batch_record.h"

namespace pomona {

namespace {

/// The difference between a folder's batch.json and the wanted one, as text: `another batch, "small"`.
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

/// The order with all options of an entry's lists: an option has an effect if it has one on any item.
Order largest_order(const BatchEntry& entry) {
  const AssetOptions& assets = entry.assets;
  Order order = assets.order;
  order.mesh.texture = *std::max_element(assets.textures.begin(), assets.textures.end());
  order.mesh.lod = *std::max_element(assets.lods.begin(), assets.lods.end());
  for (const Format format : assets.formats) order.outputs.push_back({"x." + name_of(format), format});
  return order;
}

}  // namespace

BatchPlan wanted_batch(const std::filesystem::path& file) {
  check_kind(file, FileKind::batch);
  return planned(read_batch(file), {.asking = file, .find = find_template, .all = all_templates});
}

std::vector<EntryStyles> styles_of(const BatchPlan& plan) {
  std::vector<EntryStyles> styles;
  for (const PlannedEntry& entry : plan.entries) {
    const ColorOrder& color = entry.wanted.assets.order.color;
    const auto found = [&](const std::string& style) { return find_style(style_beside(plan.batch.file, style)); };
    styles.push_back({found(drawn_style(color)), found(baked_style(color))});
  }
  return styles;
}

std::vector<std::string> batch_warnings(const BatchPlan& plan) {
  // What [batch] says holds for all entries: it is told of where no entry heeds it.
  std::set<std::string> heeded;                           // flags
  std::vector<std::pair<std::string, std::string>> idle;  // of each entry: flag and warning
  for (const PlannedEntry& entry : plan.entries) {
    const Order order = largest_order(entry.wanted);
    std::set<std::string> idle_here;
    for (const std::string& warning : idle_options(order, OrderTaker::batch, usual_batch_order())) {
      const std::string flag = warning.substr(0, warning.find(' '));
      idle.emplace_back(flag, "entry \"" + entry.wanted.name + "\": " + warning);
      idle_here.insert(flag);
    }
    for (const OrderOption& option : order_options()) {
      if (is_ordered(option, order, usual_batch_order()) && !idle_here.contains(flag_of(option)))
        heeded.insert(flag_of(option));
    }
  }
  std::vector<std::string> warnings;
  for (auto& [flag, warning] : idle)
    if (!heeded.contains(flag)) warnings.push_back(std::move(warning));
  return warnings;
}

std::string record_of(const BatchPlan& plan) { return batch_record(plan, std::string("pomona ") + version); }

void check_holds_no_other(const std::filesystem::path& folder, const std::string& there, const std::string& wanted) {
  if (there.empty() || there == wanted) return;
  const std::string what = difference(there, wanted);
  const bool can_grow = what.starts_with("this batch") || what.starts_with("a batch of another version");
  throw Error(ExitStatus::cannot_create, {{{folder.string(), 0, 0, {}},
                                           "holds " + what,
                                           std::string(can_grow ? "--update keeps what is unchanged; or " : "") +
                                               "name another folder, or remove this one"}});
}

void check_holds_no_other_name(const std::filesystem::path& folder, const std::string& there,
                               const std::string& wanted) {
  const std::string what = there.empty() || there == wanted ? std::string() : difference(there, wanted);
  if (what.starts_with("another batch") || what.ends_with("cannot be read"))
    check_holds_no_other(folder, there, wanted);
}

}  // namespace pomona
