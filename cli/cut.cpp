// pomona cut: a fruit's pieces, or the bare section.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/command_report.h"
#include "cli/deliver/still_at_work.h"
#include "cli/deliver/watch.h"
#include "cli/options/check_order.h"
#include "cli/options/find_style.h"
#include "cli/options/open_fruit.h"
#include "cli/options/order_options.h"
#include "cli/options/written_formats.h"
#include "generator/knife/knife_kinds.h"
#include "render/deliver/deliver.h"
#include "render/deliver/fruit_files.h"
#include "render/deliver/live_files.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/section_files.h"
#include "render/deliver/seed_row.h"

namespace pomona {

namespace {

struct CutCommand {
  std::string fruit;
  TypedOrder typed;
  Telling telling;
};

void count(const Slices& slices, StageTimes& times) {
  const CrossSection& section = slices.section;
  times.count("interior_vertices", std::count(section.interior.begin(), section.interior.end(), 1));
  times.count("section_vertices", static_cast<std::int64_t>(section.position.size()));
  times.count("section_triangles", static_cast<std::int64_t>(section.triangle.size()));
  times.count("pieces", static_cast<std::int64_t>(slices.piece_count));
}

Slices cut_up(const OrderedFruit& fruit, const Order& order, const Diffuser& diffuser, CommandReport& report) {
  Slices slices = [&] {
    // Most cuts take parts of a second, a narrow strip of peel a minute.
    const StillAtWork still(report.progress, "cutting");
    return cut_to_order(fruit, order, &diffuser);
  }();
  report.times.add(slices.times);
  report.warn(slices.warnings);
  return slices;
}

/// The pieces of each seed's fruit, side by side.
void cut_family(const std::string& word, const Order& order, const DeliverOptions& how, const Diffuser& diffuser,
                CommandReport& report) {
  std::vector<Solid> solids;
  for (const Order& one : each_seed(order)) {
    const OrderedFruit fruit = open_fruit(word, one).grown;
    report.add(fruit);
    std::vector<Solid> own = named_by_seed(cut_up(fruit, one, diffuser, report).pieces, *one.fruit.seed);
    solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  report.add(files({.placed = row_of(std::move(solids), how.style)}, order, how));
}

void cut_one(const std::string& word, const Order& order, const DeliverOptions& how, const Diffuser& diffuser,
             CommandReport& report) {
  const NamedFruit opened = open_fruit(word, order);
  const OrderedFruit& fruit = opened.grown;
  report.add(fruit);
  if (all_are(order.outputs, live_formats) && order.cut.piece_list.empty())
    return report.add(live_files({&fruit, 1}, order, how));
  Slices slices = cut_up(fruit, order, diffuser, report);
  count(slices, report.times);
  if (order.cut.section) return report.add(section_files(slices, fruit.fruit, order, how));
  Scene pieces = gathered(std::move(slices.pieces));
  pieces.paper = how.style.paper;
  report.add(cut_fruit_files(pieces, fruit, opened.drawn, diffuser, order, how));
}

ExitStatus cut_fruit(const CutCommand& command) {
  // Report all errors of the command line before the work begins.
  const Order order = read_order(
      command.typed, command.typed.texts_of("section").empty() ? formats_of(OrderTaker::cut) : section_formats());
  check_order(order, OrderTaker::cut, command.telling);
  CommandReport report(command.telling);
  const DeliverOptions how{.style = find_style(drawn_style(order.color)),
                           .texture_style = find_style(baked_style(order.color)),
                           .provenance = provenance_of(order.fruit),
                           .progress = report.told_progress()};
  report.warn(idle_options(order, OrderTaker::cut));
  const std::unique_ptr<Diffuser> diffuser = ordered_diffuser(order, how.progress);
  report.times.diffused_by(diffuser->name(), diffuser->device());
  order.fruit.seeds.empty() ? cut_one(command.fruit, order, how, *diffuser, report)
                            : cut_family(command.fruit, order, how, *diffuser, report);
  write_files(report, order, command.telling);
  return ExitStatus::done;
}

std::vector<std::string> written_by(const CutCommand& command) {
  std::vector<std::string> names = command.typed.outputs;
  for (const std::string& list : command.typed.texts_of("pieces")) names.push_back(list);
  return names;
}

/// The files that the command reads.
std::vector<std::string> read_by(const CutCommand& command) {
  std::vector<std::string> words = command.typed.texts_of("knife");
  for (const std::string& style : command.typed.texts_of("style")) words.push_back(style);
  words.push_back(command.fruit);
  return words;
}

}  // namespace

DeclaredCommand cut_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("cut", "Cut a fruit into pieces, or show the bare section");
  const auto options = std::make_shared<CutCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  add_order_options(
      *command, OrderTaker::cut,
      "What to write: .ply, .glb, .usda, .obj, .stl, .pov, .png, .svg, .html, .pomona, .xml (MuJoCo) or .urdf; - is "
      "standard output",
      options->typed);
  add_telling_options(*command, options->telling);
  command->footer("Knives, and along what they cut:\n" + knife_help());
  return {command, [options] {
            return made_or_watched(options->telling, written_by(*options), read_by(*options),
                                   [&] { return cut_fruit(*options); });
          }};
}

}  // namespace pomona
