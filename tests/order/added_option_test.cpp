// An option that is added to the table appears everywhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/options/order_options.h"
#include "cli/pages/command_line.h"
#include "cli/pages/completion.h"
#include "cli/pages/manual_page.h"
#include "generator/order/option_key.h"

namespace pomona {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The table with one more option.
std::vector<OrderOption> larger_table() {
  std::vector<OrderOption> table = order_options();
  table.push_back({.name = "ember-glow",
                   .value = NumberValue{[](Order& order) -> double& { return order.picture.dpi; }, 1, 5},
                   .unit = "watts",
                   .help = "How brightly embers glow",
                   .takers = {OrderTaker::cut},
                   .heeded = {Format::glb},
                   .makes_piece = true});
  return table;
}

TEST(AddedOption, IsTypedToldCompletedAndWritten) {
  const std::vector<OrderOption> table = larger_table();
  CLI::App app("", "pomona");
  CLI::App* cut = app.add_subcommand("cut", "");
  TypedOrder typed;
  add_order_options(*cut, OrderTaker::cut, "", typed, table);

  // Help, manual page and completions.
  EXPECT_THAT(cut->help(), HasSubstr("--ember-glow FLOAT:FLOAT in [1 - 5]"));
  const std::vector<TypedCommand> commands = command_line(app);
  EXPECT_THAT(manual_page(commands, "1"), HasSubstr("How brightly embers glow"));
  EXPECT_THAT(bash_completion(commands), HasSubstr("--ember-glow"));

  // The command line, with its range.
  app.parse("cut --knife half -o x.glb --ember-glow 3");
  const Order order = read_order(typed, {Format::glb});
  EXPECT_EQ(order.picture.dpi, 3);
  EXPECT_THROW(app.parse("cut --knife half -o x.glb --ember-glow 6"), CLI::ValidationError);

  // A piece's command, and the warning without effect.
  EXPECT_THAT(piece_words(order, table), HasSubstr(" --ember-glow 3"));
  Order of_a_picture = order;
  of_a_picture.outputs = {{"x.png", Format::png}};
  EXPECT_THAT(idle_options(of_a_picture, OrderTaker::cut, {}, table),
              testing::Contains("--ember-glow is about .glb: no output is one"));

  // A key of batch files.
  TomlDocument document("ember_glow = 2.5\n", "x.toml");
  Order read;
  read_option_key(table.back(), document.root(), read);
  document.throw_if_any();
  EXPECT_EQ(read.picture.dpi, 2.5);
}

}  // namespace
}  // namespace pomona
