// The table of options, as dictionaries.
#include "generator/order/option_key.h"
#include "generator/order/option_table.h"
#include "python/binding/python.h"

namespace pomona {

namespace {

/// What kind of value it takes, and which.
struct KindOf {
  const OrderOption& option;
  py::dict& said;

  void kind(const char* name) const { said["kind"] = name; }
  void whole() const {
    const Within range = range_of(option);
    kind("int");
    said["range"] = py::make_tuple(static_cast<int>(range.low), static_cast<int>(range.high));
  }
  void number() const {
    const Within range = range_of(option);
    kind("float");
    said["range"] = py::make_tuple(range.low, range.high);
  }
  void operator()(const FlagValue&) const { kind("bool"); }
  void operator()(const WholeValue&) const { whole(); }
  void operator()(const OptionalWholeValue&) const { whole(); }
  void operator()(const NumberValue&) const { number(); }
  void operator()(const OptionalNumberValue&) const { number(); }
  void operator()(const CountValue&) const { kind("int"); }
  void operator()(const ChoiceValue& v) const {
    kind("choice");
    said["choices"] = v.words;
  }
  void operator()(const TextValue&) const { kind("path"); }
  void operator()(const ParsedValue&) const { kind("text"); }
  void operator()(const KnivesValue&) const { kind("knives"); }
};

std::vector<std::string> takers_of(const OrderOption& option) {
  static const std::vector<std::pair<OrderTaker, const char*>> names = {{OrderTaker::grow, "grow"},
                                                                        {OrderTaker::cut, "cut"},
                                                                        {OrderTaker::plate, "plate"},
                                                                        {OrderTaker::scene, "scene"},
                                                                        {OrderTaker::batch, "batch"}};
  std::vector<std::string> all;
  for (const auto& [taker, name] : names)
    if (has_option(taker, option)) all.emplace_back(name);
  return all;
}

std::vector<std::string> formats_of(const OrderOption& option) {
  std::vector<std::string> all;
  for (const Format format : option.heeded) all.emplace_back(name_of(format));
  return all;
}

const char* name_of(OrderStep step) {
  return step == OrderStep::grow ? "grow" : step == OrderStep::cut ? "cut" : "write";
}

py::dict said_of(const OrderOption& option) {
  py::dict said;
  said["name"] = option.name;
  said["keyword"] = key_of(option);
  said["help"] = option.help;
  said["type"] = option.type;
  said["unit"] = option.unit;
  said["default"] = option.usual.empty() ? text_of_option(option, {}) : option.usual;
  said["range"] = py::none();
  said["choices"] = std::vector<std::string>();
  said["takers"] = takers_of(option);
  said["formats"] = formats_of(option);
  said["step"] = name_of(option.step);
  std::visit(KindOf{option, said}, option.value);
  return said;
}

}  // namespace

void bind_options(py::module_& module) {
  module.def("options", [] {
    py::list all;
    for (const OrderOption& option : order_options()) all.append(said_of(option));
    return all;
  });
}

}  // namespace pomona
