// pomona grow: one whole fruit, or several seeds of it side by side.
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/command_report.h"
#include "cli/deliver/watch.h"
#include "cli/options/check_order.h"
#include "cli/options/find_style.h"
#include "cli/options/open_fruit.h"
#include "cli/options/order_options.h"
#include "cli/seed_row.h"
#include "generator/piece/glass_surfaces.h"
#include "generator/scene/stand.h"
#include "render/deliver/deliver.h"
#include "render/deliver/live_files.h"

namespace pomona {

namespace {

const std::vector<Format> grow_formats = {Format::ply, Format::glb, Format::usda, Format::obj,  Format::stl,
                                          Format::pov, Format::png, Format::svg,  Format::html, Format::pomona};

struct GrowCommand {
  std::string fruit;
  TypedOrder typed;
  Telling telling;
};

/// The shells of the fruit with its cavity walls, or all its surfaces as glass.
std::vector<Solid> whole_fruit(const OrderedFruit& fruit, const Order& order, CommandReport& report) {
  if (order.mesh.surfaces) return glass_surfaces(fruit.grown, fruit.fruit, fruit.name);
  Slices whole = cut_to_order(fruit, order, nullptr);
  report.times.add(whole.times);
  report.warn(whole.warnings);
  return std::move(whole.pieces);
}

/// One whole fruit of each seed, side by side; on a page all are cut by the same knives.
void grow_family(const std::string& word, const Order& order, const DeliverOptions& how, CommandReport& report) {
  std::vector<OrderedFruit> family;
  for (const Order& one : each_seed(order)) {
    family.push_back(open_fruit(word, one).grown);
    report.add(family.back());
  }
  report.add(live_files(family, order, how));
  if (all_are(order.outputs, live_formats)) return;
  std::vector<Solid> solids;
  for (const OrderedFruit& fruit : family) {
    std::vector<Solid> own = named_by_seed(whole_fruit(fruit, order, report), fruit.origin.key.seed);
    solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  report.add(files({.placed = row_of(std::move(solids), how.style)}, order, how));
}

/// The drawn surfaces go out as they are; all other outputs share one scene of the whole fruit.
void grow_one(const std::string& word, const Order& order, const DeliverOptions& how, CommandReport& report) {
  const NamedFruit opened = open_fruit(word, order);
  const OrderedFruit& fruit = opened.grown;
  report.add(fruit);
  report.add(live_files({&fruit, 1}, order, how));
  report.add(surface_files(fruit, order));
  const Order rest = without(order, {Format::ply, Format::html, Format::pomona});
  if (rest.outputs.empty()) return;

  // In a picture it stands on the table, unless it is glass.
  Scene scene = gathered(whole_fruit(fruit, order, report));
  scene.paper = how.style.paper;
  std::optional<Scene> shown;
  if (any_is(rest.outputs, picture_formats) && !order.mesh.surfaces) shown = standing(scene);
  StageClock times;
  const std::vector<RipenessVariant> variants =
      ripeness_variants(scene.solids, fruit, opened.drawn, order, nullptr, times);
  report.times.add(times);
  report.add(files({.placed = scene,
                    .shown = shown ? &*shown : nullptr,
                    .variants = variants,
                    .plate_text = PlateText{fruit.fruit.title, fruit.fruit.latin},
                    .fruit = &fruit},
                   rest, how));
}

ExitStatus grow_fruit(const GrowCommand& command) {
  // Refuses impossible outputs before anything is grown.
  const Order order = read_order(command.typed, grow_formats);
  check_order(order, OrderTaker::grow, command.telling);
  CommandReport report(command.telling);
  report.warn(idle_options(order, OrderTaker::grow));
  const DeliverOptions how{.style = find_style(drawn_style(order.color)),
                           .texture_style = find_style(baked_style(order.color)),
                           .provenance = provenance_of(order.fruit),
                           .progress = report.told_progress()};
  order.fruit.seeds.empty() ? grow_one(command.fruit, order, how, report)
                            : grow_family(command.fruit, order, how, report);
  write_files(report, order, command.telling);
  return ExitStatus::done;
}

/// The files that the command reads.
std::vector<std::string> read_by(const GrowCommand& command) {
  std::vector<std::string> words = command.typed.texts_of("style");
  words.push_back(command.fruit);
  return words;
}

}  // namespace

DeclaredCommand grow_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("grow", "Grow one whole fruit");
  const auto options = std::make_shared<GrowCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  add_order_options(*command, OrderTaker::grow,
                    "What to write: .ply (surfaces), .glb, .usda, .obj, .stl, .pov, .png, .svg, .html or .pomona; - is "
                    "standard output",
                    options->typed);
  add_telling_options(*command, options->telling);
  return {command, [options] {
            return made_or_watched(options->telling, options->typed.outputs, read_by(*options),
                                   [&] { return grow_fruit(*options); });
          }};
}

}  // namespace pomona
