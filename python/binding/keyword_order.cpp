#include "python/binding/keyword_order.h"

#include "generator/base/error.h"
#include "generator/base/nearest_name.h"

namespace pomona {

namespace {

std::string text_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  return py::str(value);
}

/// "640x480" of (640, 480); "0,2,7" of any other sequence.
std::string joined_text(const OrderOption& option, const py::handle& values) {
  const char* const between = option.type == "SIZE" ? "x" : ",";
  std::string text;
  for (const py::handle value : values) text += (text.empty() ? "" : between) + text_of(value);
  return text;
}

bool is_sequence(const py::handle& value) {
  return !py::isinstance<py::str>(value) && !py::hasattr(value, "__fspath__") && py::hasattr(value, "__iter__");
}

/// Switches that are off say nothing, as on the command line.
void read_keyword(const OrderOption& option, const py::handle& value, Order& order) {
  if (py::hasattr(value, "__fspath__")) return read_option(option, py::str(value.attr("__fspath__")()), order);
  if (!is_sequence(value)) return read_option(option, text_of(value), order);
  if (!std::holds_alternative<KnivesValue>(option.value)) return read_option(option, joined_text(option, value), order);
  for (const py::handle knife : value) read_option(option, text_of(knife), order);
}

const OrderOption& option_of(const std::string& keyword, OrderTaker taker) {
  std::vector<std::string> known;
  for (const OrderOption& option : order_options()) {
    if (!has_option(taker, option)) continue;
    if (key_of(option) == keyword) return option;
    known.push_back(key_of(option));
  }
  const auto near = nearest_name(keyword, known);
  throw py::type_error("there is no option " + keyword + (near ? ": did you mean " + *near + "?" : ""));
}

const char* said_to(OrderStep step, OrderTaker taker) {
  if (taker == OrderTaker::scene) return "give it to scene()";
  return step == OrderStep::grow ? "give it to grow()" : "give it to cut()";
}

}  // namespace

Order with_keywords(Order order, const py::dict& given, OrderTaker taker, OrderStep from) {
  for (const auto& [name, value] : given) {
    if (value.is_none()) continue;
    const OrderOption& option = option_of(name.cast<std::string>(), taker);
    if (option.step < from)
      throw Error(ExitStatus::usage, flag_of(option) + " comes too late here", said_to(option.step, taker));
    read_keyword(option, value, order);
  }
  return order;
}

std::vector<std::string> idle_growing(const Order& order, OrderTaker taker) {
  Order writes_all = order;
  for (std::size_t i = 0; i < format_names().size(); ++i) writes_all.outputs.push_back({"any", static_cast<Format>(i)});
  return idle_options(writes_all, taker);
}

}  // namespace pomona
