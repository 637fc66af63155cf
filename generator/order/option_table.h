// The table of all options of an order. The command line, its help, the manual page and completions, keys of batch and
// scene files with their schemas, the tables of docs/reference/commands.md, the commands that pieces carry, and every
// warning that an option has no effect come from it. An option that is added here appears in all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/order/option_value.h"
#include "generator/order/order.h"

namespace pomona {

/// The commands that take orders, and batch files.
enum class OrderTaker { grow, cut, plate, scene, batch };

/// What the order must also have, so that the option has an effect.
enum class OptionNeed {
  nothing,
  a_variant,     ///< a seed or an index: the drawing does not vary
  pieces,        ///< pieces, not a bare section
  textures,      ///< --texture or --texel
  ground_truth,  ///< --aov
};

/// The step of the road that needs an option first: who takes the steps one by one gives it there, or before.
enum class OrderStep { grow, cut, write };

struct OrderOption {
  std::string name;  ///< "ripeness-variants": --ripeness-variants, ripeness_variants in files
  OptionValue value;
  std::string type = {};   ///< name of a text's kind in help: "FOLDER"
  std::string unit = {};   ///< unit of a number: "texels"
  std::string usual = {};  ///< the default in help; empty: that of Order
  std::string help;
  std::vector<OrderTaker> takers = {};
  std::vector<Format> heeded = {};  ///< the formats on which it has an effect; empty: all
  OptionNeed need = OptionNeed::nothing;
  std::string excludes = {};  ///< another option that cannot be given with it
  bool makes_piece = false;   ///< whether the command that makes a piece again repeats it
  OrderStep step = OrderStep::write;
};

/// All options, in the order in which commands list them.
const std::vector<OrderOption>& order_options();

/// \throws Error (bug) if there is none of this name.
const OrderOption& order_option(std::string_view name);

/// Whether this taker has it.
bool has_option(OrderTaker taker, const OrderOption& option);

/// "--ripeness-variants".
std::string flag_of(const OrderOption& option);

/// "ripeness_variants", as files call it.
std::string key_of(const OrderOption& option);

/// Reads a text into the order; of a switch "true" or "false". With `none_is_zero`, "0" means nothing for a number
/// whose range lies above, as in files.
/// \throws Error (usage) that names the option and its values.
void read_option(const OrderOption& option, const std::string& text, Order& order, bool none_is_zero = false);

/// Why the text is no value of the option; empty if it is one. For parsed texts only read_option() knows.
std::string fault_of_option(const OrderOption& option, const std::string& text);

/// The text for read_option(): "0.3", "final", "true" for a switch; "" if the order says nothing.
std::string text_of_option(const OrderOption& option, const Order& order);

/// Whether the order differs from `usual`, by default an order that says nothing.
bool is_ordered(const OrderOption& option, const Order& order, const Order& usual = {});

/// " --quality draft --style 'my style.toml'": the options of a command that makes a piece of this order again, ready
/// for the shell.
std::string piece_words(const Order& order, const std::vector<OrderOption>& table = order_options());

/// "--lod is about .glb .usda: no output is one": a line for each option that has no effect on this order's outputs.
std::vector<std::string> idle_options(const Order& order, OrderTaker taker, const Order& usual = {},
                                      const std::vector<OrderOption>& table = order_options());

}  // namespace pomona
