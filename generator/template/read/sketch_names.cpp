// Finds things in a sketch by name: its two layers, and the curves in them.
#include <algorithm>
#include <string>
#include <vector>

#include "generator/base/nearest_name.h"
#include "generator/template/read/sketch.h"
#include "generator/template/read/sketch_words.h"

namespace pomona {

Sketch::View Sketch::find_view(SketchView view) const {
  // The layer is the one group that has the view's name, as its label or its id.
  View result;
  for (const SvgElement& element : drawing_.elements) {
    const std::string wanted = plain_name(name_of(view));
    if (element.tag != "g" || (plain_name(element.label) != wanted && plain_name(element.id) != wanted)) continue;
    if (result.layer) {
      throw BadSketch("has two layers " + quoted_name(name_of(view)) + ", at " + place_of(drawing_, *result.layer) +
                          " and " + place_of(drawing_, element),
                      "rename one of them");
    }
    result.layer = &element;
  }
  if (!result.layer) return result;

  // What is drawn in the layer can be called by its label or its id.
  const SvgElement* const first = drawing_.elements.data();
  for (const SvgElement* e = result.layer + 1; e < first + result.layer->end; ++e) {
    const std::string label = plain_name(e->label), id = plain_name(e->id);
    if (!e->drawn) continue;
    if (!label.empty()) result.named[label].push_back(e);
    if (!id.empty() && id != label) result.named[id].push_back(e);
  }
  return result;
}

const Sketch::View& Sketch::view_of(SketchView view) const {
  const View& found = views_[view == SketchView::side ? 0 : 1];
  if (!found.layer) {
    const std::string message = "has no layer " + quoted_name(name_of(view)) + " in " + drawing_.file;
    if (!has_labels()) {
      throw BadSketch(message + ", nor anything else with a label",
                      "\"Plain SVG\" loses the names of layers and curves: save it as \"Inkscape SVG\"");
    }
    throw BadSketch(message, std::string("draw ") + (view == SketchView::side ? "vertical" : "horizontal") +
                                 " curves in a layer of that name; `pomona sketch` writes a file that has it");
  }
  return found;
}

const SvgElement& Sketch::find(SketchView view, const std::string& name) const {
  const View& in = view_of(view);
  const auto found = in.named.find(plain_name(name));
  if (found != in.named.end() && found->second.size() == 1) return *found->second.front();
  if (found != in.named.end()) {
    throw BadSketch(quoted_name(name) + " is drawn " + std::to_string(found->second.size()) + " times in the " +
                        name_of(view) + ", first at " + place_of(drawing_, *found->second[0]) + " and " +
                        place_of(drawing_, *found->second[1]),
                    "delete all but one, or give each a label of its own (Object > Layers and Objects)");
  }
  if (const SvgElement* renamed = made_unique(view, name)) return *renamed;
  fail_missing(view, name);
}

/// Both views have an axis, and editors that keep no label have to number the second: "axis2", "axis-1", "axis_2".
const SvgElement* Sketch::made_unique(SketchView view, const std::string& name) const {
  const View &in = view_of(view), &other = views_[view == SketchView::side ? 1 : 0];
  if (name != "axis" || !other.named.contains(name)) return nullptr;
  const SvgElement* only = nullptr;
  for (auto at = in.named.lower_bound(name); at != in.named.end() && at->first.starts_with(name); ++at) {
    const bool is_numbered = at->first.find_first_not_of("0123456789-", name.size()) == std::string::npos;
    if (!is_numbered || !at->second.front()->label.empty()) continue;
    if (only || at->second.size() > 1) return nullptr;
    only = at->second.front();
  }
  return only;
}

/// The name may be misspelt, or the curve may lie elsewhere.
void Sketch::fail_missing(SketchView view, const std::string& name) const {
  // One of the names that are there may be meant.
  const View& in = view_of(view);
  std::vector<std::string> known;
  for (const auto& [key, elements] : in.named) {
    const SvgElement& element = *elements.front();
    known.push_back(plain_name(element.label) == key ? element.label : element.id);
  }
  const auto near = name.size() <= 64 ? nearest_name(name, known) : std::nullopt;
  const std::string question = near ? "did you mean \"" + *near + "\"?" : "";

  // The curve may be drawn in the other view.
  const SketchView other = view == SketchView::side ? SketchView::top : SketchView::side;
  const View& elsewhere = views_[other == SketchView::side ? 0 : 1];
  const std::string missing = quoted_name(name) + " is missing in the " + name_of(view);
  const std::string move = std::string("draw it in the layer \"") + name_of(view) + "\", or move it there" +
                           (near ? "; or " + question : "");
  if (const auto there = elsewhere.named.find(plain_name(name)); there != elsewhere.named.end()) {
    throw BadSketch(missing + "; one of that name is drawn in the " + name_of(other) + " at " +
                        place_of(drawing_, *there->second.front()),
                    move);
  }

  // It may also be drawn outside both views.
  if (const SvgElement* stray = outside_the_views(name)) {
    throw BadSketch(missing + "; one of that name is drawn outside both layers at " + place_of(drawing_, *stray), move);
  }
  throw BadSketch(missing + " of " + drawing_.file, near ? question : "draw it there, and give it that label or id");
}

const SvgElement* Sketch::outside_the_views(const std::string& name) const {
  const std::string wanted = plain_name(name);
  for (const SvgElement& element : drawing_.elements) {
    if (element.drawn && (plain_name(element.label) == wanted || plain_name(element.id) == wanted)) return &element;
  }
  return nullptr;
}

/// Plain SVG has none.
bool Sketch::has_labels() const {
  return std::any_of(drawing_.elements.begin(), drawing_.elements.end(),
                     [](const SvgElement& element) { return !element.label.empty(); });
}

bool Sketch::is_group(SketchView view, const std::string& name) const {
  const SvgElement& element = find(view, name);
  return element.tag == "g";
}

}  // namespace pomona
