#include "generator/batch/batch_record.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/batch/batch_limits.h"
#include "generator/batch/option_json.h"
#include "generator/batch/record_fields.h"
#include "generator/text/read_name.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

/// Absent values become null.
template <typename Value>
Json list_of(const std::vector<std::optional<Value>>& values) {
  Json list = Json::array();
  for (const std::optional<Value>& value : values) list.push_back(value ? Json(*value) : Json(nullptr));
  return list;
}

template <typename Named>
Json names_of(const std::vector<Named>& values) {
  Json list = Json::array();
  for (const Named value : values) list.push_back(name_of(value));
  return list;
}

Json knives_of(const BatchEntry& entry) {
  Json alternatives = Json::array();
  for (const std::vector<Knife>& knives : entry.knives) {
    Json texts = Json::array();
    for (const Knife& knife : knives) texts.push_back(knife.text);
    alternatives.push_back(texts);
  }
  return alternatives;
}

Json entry_of(const BatchPlan& plan, const PlannedEntry& entry) {
  const BatchEntry& wanted = entry.wanted;
  const AssetOptions& assets = wanted.assets;
  Json json = {{"name", wanted.name}, {"items", entry.items()}, {"templates", Json::array()}};
  for (const std::size_t index : entry.templates) json["templates"].push_back(plan.templates[index].name);

  // Which variants ...
  if (!wanted.seeds.empty()) json["seeds"] = wanted.seeds;
  if (wanted.count > 0) json["count"] = wanted.count;
  if (wanted.total > 0) json["total"] = wanted.total;
  json["folds"] = list_of(wanted.folds);
  json["ripeness"] = list_of(wanted.ripeness);

  // ... and what becomes of them.
  json["browning"] = wanted.browning;
  json["knives"] = knives_of(wanted);
  json["formats"] = names_of(assets.formats);
  json["quality"] = names_of(assets.qualities);
  json["texture"] = assets.textures;
  json["maps"] = text_of_option(order_option("maps"), assets.order);
  json["lod"] = assets.lods;
  json["detail"] = assets.order.fruit.growing.detail;
  json["variation"] = assets.order.fruit.growing.variation;
  json["thumbnail"] = assets.thumbnail;
  json["thumbnail_ground"] = assets.thumbnail_on_paper ? "paper" : "transparent";
  if (assets.on_table) json["layout"] = "table";
  if (assets.apart) json["pieces"] = "apart";
  for (const OrderOption* option : batch_options()) {
    const bool is_told = json.contains(key_of(*option)) || !is_ordered(*option, assets.order);
    if (!is_told) json[key_of(*option)] = option_json(*option, assets.order);
  }
  return json;
}

constexpr const char* hint = "pomona wrote this file; make the batch again";

[[noreturn]] void fail(const SourcePlace& place, const std::string& message) { refuse_record(place, message, hint); }

double number_at(const JsonNode& node, std::string_view key, double max) {
  const JsonNode& value = node.need(key);
  const bool is_whole = value.kind == JsonNode::Kind::number && value.number == std::floor(value.number);
  if (!is_whole || value.number < 0 || value.number > max) fail(value.place(), "should be a whole number");
  return value.number;
}

/// The product of the lists that multiply after an individual is grown; see items_of(). Pictures of data sets have
/// none.
std::int64_t items_of_a_variant(const JsonNode& entry) {
  std::int64_t items = 1;
  if (std::find(entry.keys.begin(), entry.keys.end(), "knives") == entry.keys.end()) return items;
  for (const char* list : {"knives", "browning", "quality", "texture", "lod"}) {
    const JsonNode& values = entry.need(list);
    if (values.kind != JsonNode::Kind::array || values.items.empty()) fail(values.place(), "should be a list");
    items *= static_cast<std::int64_t>(values.items.size());
    if (items > max_batch_items) fail(values.place(), "has too many items");
  }
  return items;
}

}  // namespace

std::string batch_record(const BatchPlan& plan, const std::string& program) {
  const BatchDescription& batch = plan.batch;
  Json json = {{"format", 1},
               {"program", program},
               {"name", batch.name},
               {"title", batch.title},
               {"seed", batch.seed},
               {"items", plan.items()},
               {"templates", Json::array()},
               {"drawings", Json::array()},
               {"entries", Json::array()}};
  for (const PlannedTemplate& fruit : plan.templates)
    json["templates"].push_back({{"name", fruit.name}, {"sha256", fruit.sha256}});
  for (const auto& [file, hash] : plan.drawings) json["drawings"].push_back({{"file", file}, {"sha256", hash}});
  for (const auto& [file, hash] : plan.styles) json["styles"].push_back({{"file", file}, {"sha256", hash}});
  for (const PlannedEntry& entry : plan.entries) json["entries"].push_back(entry_of(plan, entry));
  return json_text(json, 1) + "\n";
}

std::int64_t RecordedBatch::items() const {
  std::int64_t sum = 0;
  for (const RecordedEntry& entry : entries) sum += entry.items;
  return sum;
}

RecordedBatch parse_batch_record(const std::string& json, const std::string& file) {
  const JsonNode root = parse_json(json, file);
  number_at(root, "format", 1);
  RecordedBatch batch{.program = text_at(root, "program", hint),
                      .name = text_at(root, "name", hint),
                      .title = text_at(root, "title", hint),
                      .seed = static_cast<std::uint64_t>(number_at(root, "seed", 0x1p53)),
                      .entries = {}};
  const JsonNode& entries = root.need("entries");
  if (entries.kind != JsonNode::Kind::array || entries.items.size() > max_batch_entries)
    fail(entries.place(), "should be a list of entries");
  for (const JsonNode& entry : entries.items) {
    // A name becomes a folder's: it must not lead elsewhere.
    const std::string name = text_at(entry, "name", hint);
    if (!is_plain_name(name)) fail(entry.place(), "has no plain name");
    batch.entries.push_back(
        {name, static_cast<std::int64_t>(number_at(entry, "items", max_batch_items)), items_of_a_variant(entry)});
  }
  if (batch.items() > max_batch_items) fail(entries.place(), "has too many items");
  return batch;
}

}  // namespace pomona
