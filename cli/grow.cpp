// pomona grow: one whole fruit, or several seeds of it side by side.
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/command_report.h"
#include "cli/deliver/watch.h"
#include "cli/options/check_order.h"
#include "cli/options/find_style.h"
#include "cli/options/open_fruit.h"
#include "cli/options/order_options.h"
#include "cli/options/written_formats.h"
#include "render/deliver/fruit_files.h"
#include "render/deliver/seed_row.h"

namespace pomona {

namespace {

struct GrowCommand {
  std::string fruit;
  TypedOrder typed;
  Telling telling;
};

/// One whole fruit of each seed.
void grow_family(const std::string& word, const Order& order, const DeliverOptions& how, CommandReport& report) {
  std::vector<OrderedFruit> family;
  for (const Order& one : each_seed(order)) {
    family.push_back(open_fruit(word, one).grown);
    report.add(family.back());
  }
  report.add(family_files(family, order, how));
}

void grow_one(const std::string& word, const Order& order, const DeliverOptions& how, CommandReport& report) {
  const NamedFruit opened = open_fruit(word, order);
  report.add(opened.grown);
  report.add(whole_fruit_files(opened.grown, opened.drawn, order, how));
}

ExitStatus grow_fruit(const GrowCommand& command) {
  // Refuse impossible outputs before anything is grown.
  const Order order = read_order(command.typed, formats_of(OrderTaker::grow));
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
                    "What to write: .ply (surfaces), .glb, .usda, .obj, .stl, .pov, .png, .svg, .html, .pomona, .xml "
                    "(MuJoCo) or .urdf; - is standard output",
                    options->typed);
  add_telling_options(*command, options->telling);
  return {command, [options] {
            return made_or_watched(options->telling, options->typed.outputs, read_by(*options),
                                   [&] { return grow_fruit(*options); });
          }};
}

}  // namespace pomona
