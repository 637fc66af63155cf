#include "generator/batch/batch_plan.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/base/beside.h"
#include "generator/base/file_bytes.h"
#include "generator/base/random.h"
#include "generator/base/sha256.h"
#include "generator/batch/batch_limits.h"
#include "generator/knife/knife_kinds.h"
#include "generator/piece/piece_origin.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

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

/// A seed of its own for each new variant: a pure function of the batch's seed, the entry's name and the number. 53
/// bits, so that every reader of JSON has it exactly; never 0, which is the fruit as drawn.
std::uint64_t new_seed(std::uint64_t batch_seed, const std::string& entry, std::int64_t number) {
  const RandomStream seeds({batch_seed, static_cast<std::uint64_t>(number)}, "batch/entry/" + entry);
  return std::max<std::uint64_t>(1, seeds.bits(0) >> 11);
}

constexpr std::size_t max_drawing = std::size_t{64} << 20;  // bytes; read_stroke.h reads no larger ones

/// The hashes of the files that knives name ("stroke:strokes.svg#wave").
void hash_drawings(BatchPlan& plan) {
  for (const BatchEntry& entry : plan.batch.entries) {
    for (const std::vector<Knife>& knives : entry.knives) {
      for (const Knife& knife : knives) {
        const std::optional<std::string> name = drawing_of_knife(knife.text);
        if (name)
          plan.drawings[*name] = sha256(file_bytes(fs::path(plan.batch.file).parent_path() / *name, max_drawing));
      }
    }
  }
}

/// The hashes of style files; what cannot be read is told by who looks for the style.
void hash_styles(BatchPlan& plan) {
  constexpr std::size_t max_style = std::size_t{1} << 20;  // bytes
  for (const BatchEntry& entry : plan.batch.entries) {
    const std::string& style = entry.assets.order.color.style;
    const std::string file = style_beside(plan.batch.file, style);
    std::error_code ignored;
    if (is_style_path(style) && fs::is_regular_file(file, ignored))
      plan.styles[style] = sha256(file_bytes(file, max_style));
  }
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
    files.push_back(template_files(wanted.all_templates, wanted.templates, source));
    PlannedEntry entry;
    entry.wanted = wanted;
    count(entry, files.back().size());
    check_size(entry, plan.items());
    plan.entries.push_back(std::move(entry));
  }

  TemplateShelf shelf;
  for (std::size_t i = 0; i < plan.entries.size(); ++i) {
    for (const fs::path& file : files[i]) {
      plan.entries[i].templates.push_back(shelf.index_of(file));
      check_fits(plan.entries[i].wanted, shelf.at(plan.entries[i].templates.back()));
    }
  }
  plan.templates = shelf.taken();
  plan.batch = std::move(batch);
  hash_drawings(plan);
  hash_styles(plan);
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

PlannedItem item_at(const BatchPlan& plan, std::size_t entry, std::int64_t number) {
  const std::int64_t of_each = plan.entries[entry].items_of_a_variant;
  std::int64_t before = 0;
  for (std::size_t i = 0; i < entry; ++i) before += plan.entries[i].variants;
  const BatchVariant variant = variant_at(plan, before + number / of_each);
  return {variant, items_of(plan.entries[entry], variant)[static_cast<std::size_t>(number % of_each)]};
}

std::string source_of(const BatchPlan& plan, const BatchVariant& variant) {
  const PlannedEntry& entry = plan.entries[variant.entry];
  const auto at = std::find(entry.templates.begin(), entry.templates.end(), variant.fruit) - entry.templates.begin();
  const auto number = static_cast<std::size_t>(at);
  const std::vector<TemplateWanted>& wanted = entry.wanted.templates;
  return number < wanted.size() ? source_word(wanted[number].name) : plan.templates[variant.fruit].name;
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
