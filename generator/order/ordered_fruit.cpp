#include "generator/order/ordered_fruit.h"

#include "generator/base/error.h"
#include "generator/base/shell_words.h"
#include "generator/order/option_table.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/sheets.h"

namespace pomona {

namespace {

OrderedFruit grown_from(const Template& variant, const std::string& name, const std::string& word, const Order& order,
                        const GrowOptions& growing, StageClock times) {
  OrderedFruit ordered;
  ordered.name = name;
  ordered.file = variant.file;
  ordered.fruit = variant;
  ordered.grown = times.time("sweep", [&] { return grow(ordered.fruit, key_of(order.fruit), growing); });
  ordered.origin = {.source = source_word(word), .key = key_of(order.fruit), .growing = growing};
  ordered.times = std::move(times);
  return ordered;
}

}  // namespace

OrderedFruit ordered_fruit(const Template& drawn, const std::string& name, const std::string& word,
                           const Order& order) {
  const GrowOptions growing = growing_of(order);
  StageClock times;
  const Template variant = times.time("vary", [&] { return variant_of(drawn, key_of(order.fruit), growing); });
  return grown_from(variant, name, word, order, growing, std::move(times));
}

OrderedFruit ordered_fruit(const Variation& variation, const std::string& name, const std::string& word,
                           const Order& order) {
  const GrowOptions growing = growing_of(order);
  if (growing.as_drawn) return ordered_fruit(variation.drawn(), name, word, order);
  StageClock times;
  const Template variant = times.time("vary", [&] { return variant_of(variation, key_of(order.fruit), growing); });
  return grown_from(variant, name, word, order, growing, std::move(times));
}

OrderedFruit fruit_of_surfaces(const std::filesystem::path& file, const Order& order) {
  const GrowOptions& growing = order.fruit.growing;
  if (growing.folds)
    throw Error(ExitStatus::usage, "--folds: " + file.string() + " holds surfaces, which have no folds to change");
  if (growing.ripeness || growing.browning > 0)
    throw Error(ExitStatus::usage,
                "--ripeness, --browning: " + file.string() + " holds surfaces, which do not say how they ripen");
  OrderedFruit ordered;
  ordered.name = file.stem().string();
  ordered.file = file.string();
  ordered.fruit.name = ordered.name;
  ordered.fruit.title = words_of(ordered.name);
  ordered.grown.swept = ordered.times.time("read", [&] { return read_surfaces(file); });
  ordered.fruit.parts = ordered.grown.swept.part_names;
  ordered.grown.sheets = ordered.times.time("sweep", [&] { return sheets(ordered.grown.swept); });
  ordered.origin = {.source = source_word(file.string()), .growing = {.as_drawn = true}};
  return ordered;
}

OrderedFruit browned(OrderedFruit fruit, double browning) {
  fruit.fruit.individual.browning = browning;
  fruit.origin.growing.browning = browning;
  return fruit;
}

bool wants_organs(const Order& order) { return !order.cut.piece_list.empty() || !order.picture.aov.empty(); }

Slices cut_to_order(const OrderedFruit& fruit, const Order& order, const Diffuser* diffuser, OrganFacts organs) {
  const CutOrder& cut = order.cut;
  SliceTask task{.grown = fruit.grown,
                 .variant = fruit.fruit,
                 .knives = cut.knives,
                 .name = fruit.name,
                 .origin = fruit.origin,
                 .crumbs = cut.crumbs};
  if (cut.piece > 0) {
    task.name += ".piece-" + std::to_string(cut.piece);
    task.choice = PieceChoice{.only = cut.piece};
  }
  SliceOptions how{.cut = cut.faces == FaceQuality::coarse ? coarse_cut : CutOptions{},
                   .pieces = !cut.section,
                   .keep_section_colors = wants_textures(order.mesh),
                   .organs = organs == OrganFacts::always || wants_organs(order),
                   .threads = order.threads};
  how.cut.threads = order.threads;
  try {
    Slices slices = slice(task, diffuser, how);
    if (cut.piece > 0 && slices.piece_count == 0)
      throw Error(ExitStatus::usage, "--piece " + std::to_string(cut.piece) + ": there are fewer pieces");
    return slices;
  } catch (const Error& error) {
    if (error.status() != ExitStatus::bad_data) throw;
    throw told_of(error, fruit.file);
  }
}

Order order_of(const PieceOrigin& origin) {
  Order order;
  order.fruit.growing = origin.growing;
  const auto& [seed, index] = origin.key;

  // Seed 0 without an index is the drawing; with one it is a variant like any other.
  const bool is_plain_drawing = origin.growing.as_drawn && seed == 0 && index == 0;
  if (is_plain_drawing) {
    order.fruit.growing.as_drawn = false;
  } else {
    order.fruit.seed = seed;
    if (index != 0 || seed == 0) order.fruit.index = index;
  }
  if (origin.knives.empty()) {
    order.fruit.growing.browning = 0;
  } else {
    for (const std::string& knife : origin.knives) order.cut.knives.push_back({.text = knife});
    order.cut.faces = origin.coarse ? FaceQuality::coarse : FaceQuality::fine;
  }
  if (origin.pieces > 1) order.cut.piece = origin.number;
  return order;
}

std::string command_for(const PieceOrigin& origin, const std::string& file, const std::string& further) {
  if (origin.source.empty() || origin.number == 0) return {};
  return std::string("pomona ") + (origin.knives.empty() ? "grow " : "cut ") + shell_word(origin.source) +
         piece_words(order_of(origin)) + further + " -o " + shell_word(source_word(file));
}

}  // namespace pomona
