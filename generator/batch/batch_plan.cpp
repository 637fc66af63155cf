#include "generator/batch/batch_plan.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/base/random.h"
#include "generator/base/small_ending.h"
#include "generator/batch/batch_limits.h"
#include "generator/batch/template_hash.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// The file behind a name; a fault is reported at the name's place in the batch.
fs::path template_file(const TemplateWanted& wanted, const TemplateSource& source) {
  try {
    const fs::path file = source.find(wanted.name);
    if (small_ending(file) != ".ply") return file;
  } catch (const Error& error) {
    const Diagnostic& what = error.diagnostics().front();
    throw Error(error.status(), {{wanted.place, what.message, what.hint}});
  }
  throw Error(ExitStatus::bad_data, {{wanted.place, "\"" + wanted.name + "\" holds surfaces, which have no variants",
                                      "a template takes them as a [[mesh]] (docs/guides/import.md)"}});
}

std::vector<fs::path> template_files(const BatchEntry& entry, const TemplateSource& source) {
  if (entry.all_templates) return source.all();
  std::vector<fs::path> files;
  for (const TemplateWanted& wanted : entry.templates) files.push_back(template_file(wanted, source));
  return files;
}

/// Counts with a limit, so that no product is too large for its type.
std::int64_t product(std::initializer_list<std::size_t> factors) {
  std::int64_t product = 1;
  for (const std::size_t factor : factors) {
    product *= std::min<std::int64_t>(static_cast<std::int64_t>(factor), max_batch_items + 1);
    product = std::min<std::int64_t>(product, max_batch_items + 1);
  }
  return product;
}

/// The number of individuals, and of items of each.
void count(PlannedEntry& entry, std::size_t templates) {
  const BatchEntry& wanted = entry.wanted;
  const AssetOptions& assets = wanted.assets;
  const std::size_t of_each = wanted.seeds.empty() ? static_cast<std::size_t>(wanted.count) : wanted.seeds.size();
  const std::int64_t drawn = wanted.total > 0 ? wanted.total : product({templates, of_each});
  entry.variants = product({static_cast<std::size_t>(drawn), wanted.folds.size(), wanted.ripeness.size()});
  entry.items_of_a_variant = product({wanted.knives.size(), wanted.browning.size(), assets.qualities.size(),
                                      assets.textures.size(), assets.lods.size()});
}

void check_size(const PlannedEntry& entry, std::int64_t before) {
  const std::int64_t items =
      product({static_cast<std::size_t>(entry.variants), static_cast<std::size_t>(entry.items_of_a_variant)});
  if (before + items <= max_batch_items) return;
  throw Error(ExitStatus::bad_data, {{entry.wanted.place,
                                      "entry \"" + entry.wanted.name + "\" takes the batch beyond " +
                                          std::to_string(max_batch_items) + " items: its lists multiply",
                                      "shorten them, or make batches of their own"}});
}

/// Refuses an entry that asks of a template what that does not declare.
void check_fits(const BatchEntry& entry, const PlannedTemplate& found) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ExitStatus::bad_data, {{entry.place, "entry \"" + entry.name + "\": \"" + found.name + "\" " + why,
                                        "give the templates that do an entry of their own"}});
  };
  const Template& fruit = found.fruit;
  const auto is_brown = [](double browning) { return browning > 0; };
  if (entry.folds.front() && !std::holds_alternative<FoldSymmetry>(fruit.symmetry)) refuse("has no folds");
  if (entry.ripeness.front() && !fruit.ripeness.declared()) refuse("does not say how it ripens");
  if (std::any_of(entry.browning.begin(), entry.browning.end(), is_brown) && !fruit.browning.declared())
    refuse("does not say how it turns brown");
}

/// The index of the template in the file, read unless it has been.
std::size_t index_of(const fs::path& file, std::vector<fs::path>& known, std::vector<PlannedTemplate>& templates) {
  const auto found = std::find(known.begin(), known.end(), file);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  known.push_back(file);
  templates.push_back({file.stem().string(), template_hash(file), read_template(file)});
  return templates.size() - 1;
}

/// A seed of its own for each new variant: a pure function of the batch's seed, the entry's name and the number. 53
/// bits, so that every reader of JSON has it exactly; never 0, which is the fruit as drawn.
std::uint64_t new_seed(std::uint64_t batch_seed, const std::string& entry, std::int64_t number) {
  const RandomStream seeds({batch_seed, static_cast<std::uint64_t>(number)}, "batch/entry/" + entry);
  return std::max<std::uint64_t>(1, seeds.bits(0) >> 11);
}

/// Digits that number `count` things from 0, in threes.
int digits_for(std::int64_t count) {
  int digits = 3;
  for (std::int64_t max = 1000; max < count; max *= 1000) digits += 3;
  return digits;
}

}  // namespace

std::int64_t BatchPlan::variants() const {
  std::int64_t sum = 0;
  for (const PlannedEntry& entry : entries) sum += entry.variants;
  return sum;
}

std::int64_t BatchPlan::items() const {
  std::int64_t sum = 0;
  for (const PlannedEntry& entry : entries) sum += entry.items();
  return sum;
}

BatchPlan planned(BatchDescription batch, const TemplateSource& source) {
  // The number is known before any template is read.
  BatchPlan plan;
  std::vector<std::vector<fs::path>> files;
  for (const BatchEntry& wanted : batch.entries) {
    files.push_back(template_files(wanted, source));
    PlannedEntry entry;
    entry.wanted = wanted;
    count(entry, files.back().size());
    check_size(entry, plan.items());
    plan.entries.push_back(std::move(entry));
  }

  std::vector<fs::path> known;
  for (std::size_t i = 0; i < plan.entries.size(); ++i) {
    for (const fs::path& file : files[i]) {
      plan.entries[i].templates.push_back(index_of(file, known, plan.templates));
      check_fits(plan.entries[i].wanted, plan.templates[plan.entries[i].templates.back()]);
    }
  }
  plan.batch = std::move(batch);
  return plan;
}

BatchVariant variant_at(const BatchPlan& plan, std::int64_t index) {
  BatchVariant variant;
  while (index >= plan.entries[variant.entry].variants) index -= plan.entries[variant.entry++].variants;
  variant.number = index;

  // The last list turns fastest.
  const PlannedEntry& entry = plan.entries[variant.entry];
  const BatchEntry& wanted = entry.wanted;
  std::size_t rest = static_cast<std::size_t>(index);
  const auto pick = [&rest](std::size_t size) { return std::exchange(rest, rest / size) % size; };
  variant.ripeness = wanted.ripeness[pick(wanted.ripeness.size())];
  variant.folds = wanted.folds[pick(wanted.folds.size())];

  // The rest is the index of the individual: all of the first template before those of the next, or in turn.
  const std::size_t individual = rest, templates = entry.templates.size();
  const std::size_t of_each = wanted.seeds.empty() ? static_cast<std::size_t>(wanted.count) : wanted.seeds.size();
  variant.fruit = entry.templates[wanted.total > 0 ? individual % templates : individual / of_each];
  variant.seed = wanted.seeds.empty() ? new_seed(plan.batch.seed, wanted.name, static_cast<std::int64_t>(individual))
                                      : wanted.seeds[individual % of_each];
  return variant;
}

std::vector<BatchItem> items_of(const PlannedEntry& entry, const BatchVariant& variant) {
  std::vector<BatchItem> items;
  const AssetOptions& assets = entry.wanted.assets;
  std::int64_t number = variant.number * entry.items_of_a_variant;
  for (std::size_t knives = 0; knives < entry.wanted.knives.size(); ++knives)
    for (const double browning : entry.wanted.browning)
      for (const Quality quality : assets.qualities)
        for (const int texture : assets.textures)
          for (const int lod : assets.lods) items.push_back({number++, knives, browning, quality, texture, lod});
  return items;
}

Order order_of(const BatchPlan& plan, const BatchVariant& variant) {
  Order order = plan.entries[variant.entry].wanted.assets.order;
  order.fruit.seed = variant.seed;
  order.fruit.growing.folds = variant.folds;
  order.fruit.growing.ripeness = variant.ripeness;
  return order;
}

Order order_of(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item) {
  const BatchEntry& wanted = plan.entries[variant.entry].wanted;
  Order order = order_of(plan, variant);
  order.fruit.growing.browning = item.browning;
  order.cut.knives = wanted.knives[item.knives];
  order.color.quality = item.quality;
  order.mesh.texture = item.texture;
  order.mesh.lod = item.lod;
  const std::string& name = plan.templates[variant.fruit].name;
  for (const Format format : wanted.assets.formats) order.outputs.push_back({name + "." + name_of(format), format});
  return order;
}

std::string item_folder(std::int64_t items, std::int64_t number) {
  std::string digits = std::to_string(number);
  const int width = digits_for(items);
  digits.insert(0, static_cast<std::size_t>(width) - digits.size(), '0');
  for (int at = width - 3; at > 0; at -= 3) digits.insert(static_cast<std::size_t>(at), 1, '/');
  return digits;
}

std::string item_path(const std::string& entry, std::int64_t items, std::int64_t number) {
  return entry + "/" + item_folder(items, number);
}

}  // namespace pomona
