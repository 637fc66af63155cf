#include "generator/batch/item_record.h"

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/sha256.h"
#include "generator/base/version.h"
#include "generator/batch/option_json.h"
#include "generator/batch/record_fields.h"
#include "generator/knife/knife_kinds.h"
#include "generator/piece/facts_json.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

Json piece_of(const Solid& solid) {
  Json piece = {{"name", solid.name}};
  piece.update(facts_with_organs_json(solid));
  return piece;
}

/// Where an item lies; records begin with it.
Json place_of(const std::string& entry, std::int64_t items, std::int64_t number) {
  return {{"item", item_path(entry, items, number)}, {"entry", entry}, {"number", number}};
}

/// The origin of the item, enough to make it again by `pomona cut`.
Json origin_of(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item) {
  const PlannedEntry& entry = plan.entries[variant.entry];
  const PlannedTemplate& fruit = plan.templates[variant.fruit];
  Json json = {{"template", fruit.name}, {"template_sha256", fruit.sha256}, {"seed", variant.seed}};
  if (variant.folds) json["folds"] = *variant.folds;
  if (variant.ripeness) json["ripeness"] = *variant.ripeness;
  json["knives"] = Json::array();
  for (const Knife& knife : entry.wanted.knives[item.knives]) json["knives"].push_back(knife.text);
  if (item.browning > 0) json["browning"] = item.browning;
  json["quality"] = name_of(item.quality);
  if (item.texture > 0) json["texture"] = item.texture;
  const Order& order = entry.wanted.assets.order;
  if (item.texture > 0 && order.mesh.maps == Maps::all) json["maps"] = "all";
  if (item.lod > 0) json["lod"] = item.lod;
  for (const OrderOption* option : batch_options()) {
    if (option->name != "maps" && is_ordered(*option, order)) json[key_of(*option)] = option_json(*option, order);
  }
  return json;
}

const JsonNode* find(const JsonNode& node, std::string_view key) {
  for (std::size_t i = 0; i < node.keys.size(); ++i)
    if (node.keys[i] == key) return &node.items[i];
  return nullptr;
}

constexpr const char* hint = "remove the item's folder, and go on with --resume";

[[noreturn]] void fail(const SourcePlace& place, const std::string& message) { refuse_record(place, message, hint); }

double number_at(const JsonNode& node, std::string_view key) {
  const JsonNode& value = node.need(key);
  if (value.kind != JsonNode::Kind::number) fail(value.place(), "should be a number");
  return value.number;
}

/// Sizes and numbers that may be cast: whole, from 0 to what a double holds exactly.
std::uint64_t whole_at(const JsonNode& node, std::string_view key) {
  const double value = number_at(node, key);
  if (!(value >= 0 && value <= 0x1p53)) fail(node.need(key).place(), "should be a whole number");
  return static_cast<std::uint64_t>(value);
}

RecordedFile file_of(const JsonNode& node) {
  RecordedFile file{text_at(node, "name", hint), whole_at(node, "bytes"), text_at(node, "sha256", hint)};
  const bool leads_elsewhere =
      file.name.empty() || file.name.front() == '.' || file.name.find('/') != std::string::npos;
  if (leads_elsewhere) fail(node.place(), "has no plain name");
  return file;
}

}  // namespace

std::string item_recipe(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item) {
  const BatchEntry& entry = plan.entries[variant.entry].wanted;
  Json json = origin_of(plan, variant, item);
  json["program"] = std::string("pomona ") + version;
  json["source"] = source_of(plan, variant);
  json["formats"] = Json::array();
  for (const Format format : entry.assets.formats) json["formats"].push_back(name_of(format));
  json["thumbnail"] = entry.assets.thumbnail;
  json["thumbnail_on_paper"] = entry.assets.thumbnail_on_paper;
  json["on_table"] = entry.assets.on_table;
  json["apart"] = entry.assets.apart;

  // Files that it names count by what they hold.
  json["files"] = Json::array();
  for (const Knife& knife : entry.knives[item.knives])
    if (const auto drawing = drawing_of_knife(knife.text)) json["files"].push_back(plan.drawings.at(*drawing));
  const auto style = plan.styles.find(entry.assets.order.color.style);
  if (style != plan.styles.end()) json["files"].push_back(style->second);
  return sha256(json_text(json));
}

std::string moved_record(const std::string& record, const std::string& entry, std::int64_t items, std::int64_t number) {
  Json moved = place_of(entry, items, number);
  const Json old = Json::parse(record, nullptr, false);
  if (!old.is_object()) fail({"item.json", 1, 1, {}}, "is no object");
  for (const auto& [key, value] : old.items())
    if (!moved.contains(key)) moved[key] = value;
  return json_text(moved) + "\n";
}

std::string item_record(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item,
                        const ItemOutcome& outcome) {
  const PlannedEntry& entry = plan.entries[variant.entry];
  Json json = place_of(entry.wanted.name, entry.items(), item.number);
  json.update(origin_of(plan, variant, item));
  json["recipe"] = item_recipe(plan, variant, item);
  if (!outcome.error.empty()) json["error"] = outcome.error;
  json["pieces"] = Json::array();
  for (const Solid& solid : outcome.pieces) json["pieces"].push_back(piece_of(solid));
  json["warnings"] = outcome.warnings;
  json["files"] = Json::array();
  for (const RecordedFile& file : outcome.files)
    json["files"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return json_text(json) + "\n";
}

RecordedItem parse_item_record(const std::string& json, const std::string& file) {
  const JsonNode root = parse_json(json, file);
  RecordedItem item{.item = text_at(root, "item", hint),
                    .recipe = find(root, "recipe") ? text_at(root, "recipe", hint) : std::string(),
                    .template_name = text_at(root, "template", hint),
                    .seed = whole_at(root, "seed"),
                    .knives = {},
                    .files = {},
                    .error = find(root, "error") ? text_at(root, "error", hint) : std::string()};
  for (const JsonNode& knife : root.need("knives").items) item.knives += (item.knives.empty() ? "" : " ") + knife.text;
  for (const JsonNode& piece : root.need("pieces").items) item.volume += number_at(piece, "volume");
  item.pieces = root.need("pieces").items.size();
  for (const JsonNode& node : root.need("files").items) item.files.push_back(file_of(node));
  return item;
}

}  // namespace pomona
