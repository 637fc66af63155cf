// A batch ready to be made: templates are read, lists multiplied. Items are not stored; each is computed from its
// number, so that ten million of them need no memory.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/batch/batch_file.h"
#include "generator/batch/planned_templates.h"
#include "generator/variation/variation.h"

namespace pomona {

/// An entry whose templates have been found.
struct PlannedEntry {
  BatchEntry wanted;
  std::vector<std::size_t> templates;   ///< indices into BatchPlan::templates
  std::int64_t variants = 0;            ///< individuals to grow
  std::int64_t items_of_a_variant = 0;  ///< number of items of each individual
  std::int64_t items() const { return variants * items_of_a_variant; }
};

struct BatchPlan {
  BatchDescription batch;
  std::vector<PlannedTemplate> templates;  ///< each once
  std::vector<PlannedEntry> entries;
  std::map<std::string, std::string> drawings;  ///< SHA-256 of the files that knives name, from the batch's folder
  std::map<std::string, std::string> styles;    ///< SHA-256 of the style files that entries name
  std::int64_t variants() const;
  std::int64_t items() const;
};

/// \throws Error (bad_data) with the entry's place if there are more than max_batch_items, or if a template does not
/// have what the entry asks of it; (input_missing) with the place of a name that is no template.
BatchPlan planned(BatchDescription batch, const TemplateSource& source);

/// One individual of an entry, grown once for all of its items.
struct BatchVariant {
  std::size_t entry = 0;
  std::int64_t number = 0;  ///< within the entry, from 0
  std::size_t fruit = 0;    ///< index into BatchPlan::templates
  std::uint64_t seed = 0;   ///< as `pomona cut --seed` takes it; 0 = as drawn. New ones have at most 53 bits
  std::optional<int> folds;
  std::optional<double> ripeness;
};

/// \param index 0 up to BatchPlan::variants(), over all entries in their order.
BatchVariant variant_at(const BatchPlan& plan, std::int64_t index);

/// One item: a folder of files.
struct BatchItem {
  std::int64_t number = 0;  ///< within the entry, from 0
  std::size_t knives = 0;   ///< index into BatchEntry::knives
  double browning = 0;
  Quality quality = Quality::draft;
  int texture = 0, lod = 0;
};

/// The item of this number within an entry.
struct PlannedItem {
  BatchVariant variant;
  BatchItem item;
};
PlannedItem item_at(const BatchPlan& plan, std::size_t entry, std::int64_t number);

/// The template's name or path, as an argument of `pomona cut`.
std::string source_of(const BatchPlan& plan, const BatchVariant& variant);

/// The individual as ordered: its seed and how it grows.
Order order_of(const BatchPlan& plan, const BatchVariant& variant);

/// The item as ordered: knives, colours and files, which have the template's name.
Order order_of(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item);

/// The items of a variant, in their order.
std::vector<BatchItem> items_of(const PlannedEntry& entry, const BatchVariant& variant);

/// The folder of an item in an entry with `items` items: "042", or "012/042" among more than a thousand. No folder has
/// more than a thousand.
std::string item_folder(std::int64_t items, std::int64_t number);

/// The same from the batch's folder, "halves/042": the item's name in manifests.
std::string item_path(const std::string& entry, std::int64_t items, std::int64_t number);

}  // namespace pomona
