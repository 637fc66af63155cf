// Fruit, its pieces and its sections.
#include <iterator>
#include <optional>
#include <utility>

#include "cli/options/check_order.h"
#include "cli/options/open_fruit.h"
#include "cli/options/written_formats.h"
#include "generator/order/ordered_fruit.h"
#include "generator/template/read/read_template.h"
#include "python/binding/array_views.h"
#include "python/binding/keyword_order.h"
#include "python/binding/solid_set.h"
#include "python/binding/work.h"
#include "render/deliver/deliver.h"
#include "render/deliver/fruit_files.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/section_files.h"
#include "render/deliver/seed_row.h"

namespace pomona {

namespace {

/// One fruit, or several seeds of it.
struct GrownFamily {
  std::vector<OrderedFruit> fruits;
  std::optional<Template> drawn;  ///< none of a surface file

  bool is_one(const Order& order) const { return order.fruit.seeds.empty(); }
};

class WholeFruit : public Deliverable {
 public:
  WholeFruit(Order order, GrownFamily family)
      : Deliverable(std::move(order), OrderTaker::grow), family_(std::move(family)) {}

  Delivered deliver(const Order& order, const DeliverOptions& how) const override {
    return family_.is_one(order) ? whole_fruit_files(family_.fruits.front(), family_.drawn, order, how)
                                 : family_files(family_.fruits, order, how);
  }
  const std::vector<Format>& formats() const override { return formats_of(OrderTaker::grow); }
  OrderStep next_step() const override { return OrderStep::cut; }
  const GrownFamily& family() const { return family_; }

 private:
  GrownFamily family_;
};

using Whole = std::shared_ptr<WholeFruit>;

class FruitPieces : public SolidSet {
 public:
  FruitPieces(Order order, Scene pieces, Whole whole, std::shared_ptr<const Diffuser> diffuser)
      : SolidSet(std::move(order), OrderTaker::cut, std::move(pieces), std::move(diffuser)), whole_(std::move(whole)) {}

  Delivered deliver(const Order& order, const DeliverOptions& how) const override {
    const GrownFamily& family = whole_->family();
    if (!family.is_one(order)) return files({.placed = scene()}, order, how);
    return cut_fruit_files(scene(), family.fruits.front(), family.drawn, diffuser(), order, how);
  }
  const std::vector<Format>& formats() const override { return formats_of(OrderTaker::cut); }

 private:
  Whole whole_;
};

class BareSection : public Deliverable {
 public:
  BareSection(Order order, Slices slices, Whole whole)
      : Deliverable(std::move(order), OrderTaker::cut), slices_(std::move(slices)), whole_(std::move(whole)) {}

  Delivered deliver(const Order& order, const DeliverOptions& how) const override {
    return section_files(slices_, whole_->family().fruits.front().fruit, order, how);
  }
  const std::vector<Format>& formats() const override { return section_formats(); }
  const CrossSection& section() const { return slices_.styled; }

 private:
  Slices slices_;
  Whole whole_;
};

void take(std::vector<std::string> warnings, Telltale& telltale) {
  telltale.warnings.insert(telltale.warnings.end(), warnings.begin(), warnings.end());
}

/// \param text of a template; else `word` is its name or path.
GrownFamily grown(const std::string& word, const std::optional<std::string>& text, const Order& order) {
  GrownFamily family;
  if (text) family.drawn = parse_template(*text, word);
  for (const Order& one : order.fruit.seeds.empty() ? std::vector{order} : each_seed(order)) {
    if (text) {
      family.fruits.push_back(ordered_fruit(*family.drawn, family.drawn->name, {}, one));
      continue;
    }
    NamedFruit opened = open_fruit(word, one);
    family.fruits.push_back(std::move(opened.grown));
    family.drawn = std::move(opened.drawn);
  }
  return family;
}

Whole grow_fruit(const std::string& word, const std::optional<std::string>& text, const py::dict& given,
                 const py::object& progress) {
  const Order order = with_keywords({}, given, OrderTaker::grow, OrderStep::grow);
  Whole whole;
  run_work(progress, [&](Telltale& telltale) {
    take(idle_growing(order, OrderTaker::grow), telltale);
    whole = std::make_shared<WholeFruit>(order, grown(word, text, order));
  });
  return whole;
}

/// The fruit as it is to be cut: only browning makes another one of it.
Whole ready_to_cut(const Whole& whole, const Order& order) {
  const double browning = order.fruit.growing.browning;
  if (browning == whole->order().fruit.growing.browning) return whole;
  GrownFamily family = whole->family();
  for (OrderedFruit& fruit : family.fruits) fruit = browned(std::move(fruit), browning);
  return std::make_shared<WholeFruit>(order, std::move(family));
}

/// All pieces: of one fruit where they grew, of several side by side.
Scene cut_up(const GrownFamily& family, const Order& order, const Diffuser& diffuser, Telltale& telltale) {
  const Style style = ordered_style(order);
  std::vector<Solid> solids;
  for (const OrderedFruit& fruit : family.fruits) {
    Slices slices = cut_to_order(fruit, order, &diffuser, OrganFacts::always);
    take(std::move(slices.warnings), telltale);
    std::vector<Solid> own = std::move(slices.pieces);
    if (!family.is_one(order)) own = named_by_seed(std::move(own), fruit.origin.key.seed);
    solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  if (!family.is_one(order)) return row_of(std::move(solids), style);
  Scene pieces = gathered(std::move(solids));
  pieces.paper = style.paper;
  return pieces;
}

std::shared_ptr<Deliverable> cut_fruit(const Whole& whole, const py::dict& given, const py::object& progress) {
  const Order order = with_keywords(whole->order(), given, OrderTaker::cut, OrderStep::cut);
  std::shared_ptr<Deliverable> cut;
  run_work(progress, [&](Telltale& telltale) {
    const std::shared_ptr<const Diffuser> diffuser = ordered_diffuser(order, telltale.progress);
    const Whole ready = ready_to_cut(whole, order);
    if (!order.cut.section) {
      cut = std::make_shared<FruitPieces>(order, cut_up(ready->family(), order, *diffuser, telltale), ready, diffuser);
      return;
    }
    check_order(order, OrderTaker::cut, {});
    Slices slices = cut_to_order(ready->family().fruits.front(), order, diffuser.get());
    take(slices.warnings, telltale);
    cut = std::make_shared<BareSection>(order, std::move(slices), ready);
  });
  return cut;
}

py::dict section_arrays(const std::shared_ptr<BareSection>& of) {
  const CrossSection& section = of->section();
  py::dict all;
  all["positions"] = rows_of<float>(section.position, of);
  all["colors"] = rows_of<float>(section.color, of);
  all["parts"] = numbers_of(section.part, of);
  all["triangles"] = rows_of<std::uint32_t>(section.triangle, of);
  all["cut_faces"] = numbers_of(section.cut, of);
  all["part_names"] = section.part_names;
  return all;
}

}  // namespace

void bind_fruit(py::module_& module) {
  py::class_<WholeFruit, Deliverable, Whole>(module, "WholeFruit")
      .def("cut", &cut_fruit)
      .def_property_readonly("name", [](const WholeFruit& whole) { return whole.family().fruits.front().name; })
      .def_property_readonly("title", [](const WholeFruit& whole) { return whole.family().fruits.front().fruit.title; })
      .def_property_readonly("part_names",
                             [](const WholeFruit& whole) { return whole.family().fruits.front().fruit.parts; });
  py::class_<FruitPieces, SolidSet, std::shared_ptr<FruitPieces>>(module, "FruitPieces");
  py::class_<BareSection, Deliverable, std::shared_ptr<BareSection>>(module, "BareSection")
      .def("arrays", &section_arrays);
  module.def("grow", &grow_fruit);
}

}  // namespace pomona
