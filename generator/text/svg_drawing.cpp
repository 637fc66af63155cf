// The one file that knows pugixml, which reads the XML.
#include "generator/text/svg_drawing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include <pugixml.hpp>

#include "generator/base/units.h"
#include "generator/text/svg_shapes.h"
#include "generator/text/svg_style.h"
#include "generator/text/text_places.h"

namespace pomona {

namespace {

constexpr std::size_t max_bytes = std::size_t{64} << 20;  // limit of a file, with room for an embedded photograph
constexpr std::size_t max_elements = 200000, max_attributes = 4000000;
constexpr std::size_t max_path_bytes = std::size_t{256} << 10;  // limit of a path: some 5000 nodes
constexpr int deepest = 64;
constexpr std::size_t max_style_rules = 200;  // limit of rules that concern geometry: each is held against each element

std::string at_place(const std::string& file, int line, int column) {
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

// ---- Names of XML: they belong to a namespace, whatever a file shortens that to ----

constexpr std::string_view svg_space = "http://www.w3.org/2000/svg", xlink_space = "http://www.w3.org/1999/xlink",
                           inkscape_space = "http://www.inkscape.org/namespaces/inkscape",
                           serif_space = "http://www.serif.com/";

/// The usual namespace of a prefix, for files that do not declare it, or declare it by an entity, which is not
/// expanded.
std::string_view usual_space(std::string_view prefix) {
  if (prefix.empty() || prefix == "svg") return svg_space;
  if (prefix == "xlink") return xlink_space;
  if (prefix == "inkscape") return inkscape_space;
  return prefix == "serif" ? serif_space : std::string_view();
}

/// A name of XML: its namespace and its local name.
struct XmlName {
  std::string_view space, local;
};

/// The namespaces that an element declares and those around it.
class Namespaces {
 public:
  /// The namespaces within this element.
  Namespaces within(const pugi::xml_node& node) const {
    Namespaces result = *this;
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      std::string_view name = attribute.name();
      if (!name.starts_with("xmlns") || (name.size() > 5 && name[5] != ':')) continue;
      name.remove_prefix(std::min<std::size_t>(6, name.size()));
      result.spaces_.emplace_back(name, attribute.value());
    }
    return result;
  }

  XmlName name_of(const pugi::xml_node& node) const { return split(node.name(), true); }

  std::string_view attribute(const pugi::xml_node& node, std::string_view space, std::string_view local) const {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const XmlName name = split(attribute.name(), false);
      if (name.local == local && name.space == space) return attribute.value();
    }
    return {};
  }

 private:
  /// Attributes without a prefix belong to no namespace.
  XmlName split(std::string_view name, bool is_element) const {
    const std::size_t colon = name.find(':');
    const std::string_view prefix = colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
    const std::string_view local = colon == std::string_view::npos ? name : name.substr(colon + 1);
    if (prefix.empty() && !is_element) return {{}, local};
    const auto declared =
        std::find_if(spaces_.rbegin(), spaces_.rend(), [&](const auto& s) { return s.first == prefix; });
    const bool is_known = declared != spaces_.rend() && !declared->second.starts_with('&');
    return {is_known ? declared->second : usual_space(prefix), local};
  }

  std::vector<std::pair<std::string_view, std::string_view>> spaces_;  ///< the innermost last
};

/// The name of a layer or a curve behind the id that an editor has made of it: Illustrator writes "fold 1" as
/// "fold_x0020_1", and a second "axis" as "axis_1_".
std::string name_behind(std::string_view id) {
  std::string name;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const std::size_t end = id.find('_', i + 1);
    const bool is_code = id.substr(i).starts_with("_x") && end != std::string_view::npos && end > i + 2 && end <= i + 6;
    int code = 0;
    if (is_code) {
      const std::string_view digits = id.substr(i + 2, end - i - 2);
      const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
      if (status != std::errc() || stop != digits.data() + digits.size()) code = 0;
    }
    if (code >= ' ' && code <= '~') {
      name += static_cast<char>(code);
      i = end;
    } else {
      name += id[i];
    }
  }
  if (!name.ends_with('_')) return name;
  const std::size_t number = name.find_last_of('_', name.size() - 2);
  const bool is_number = number != std::string::npos && number > 0 && number + 2 < name.size() &&
                         name.find_first_not_of("0123456789", number + 1) == name.size() - 1;
  return is_number ? name.substr(0, number) : name;
}

bool is_container_of_what_is_not_drawn(std::string_view tag) {
  constexpr std::string_view tags[] = {"defs", "symbol", "clipPath", "mask", "pattern", "marker"};
  return std::find(std::begin(tags), std::end(tags), tag) != std::end(tags);
}

/// Collects the style sheets of a drawing, wherever they stand.
struct StyleSheets : pugi::xml_tree_walker {
  bool for_each(pugi::xml_node& node) override {
    std::string_view name = node.name();
    if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
    if (name != "style") return true;
    for (const pugi::xml_node& child : node.children()) text += child.value();
    text += "\n";
    return true;
  }
  std::string text;
};

std::vector<SvgStyleRule> style_rules_of(pugi::xml_document& document, const std::string& file) {
  StyleSheets sheets;
  document.traverse(sheets);
  std::vector<SvgStyleRule> rules = geometry_rules(sheets.text);
  if (rules.size() > max_style_rules) {
    throw BadSketch(at_place(file, 1, 1) + ": its style sheets move or shape things by more than " +
                        std::to_string(max_style_rules) + " rules",
                    "save it from Inkscape as \"Inkscape SVG\"");
  }
  return rules;
}

/// Reads the elements below a root; each inherits from the one around it.
class SvgReader {
 public:
  SvgReader(std::string_view text, std::vector<SvgStyleRule> rules, SvgDrawing& drawing)
      : places_(text, drawing.file), rules_(std::move(rules)), drawing_(drawing) {}

  void read(const pugi::xml_node& node, const SvgElement& around, int depth, const Namespaces& outer) {
    if (node.type() != pugi::node_element) return;
    const Namespaces names = outer.within(node);
    const std::size_t index = drawing_.elements.size();
    drawing_.elements.push_back(element(node, around, names));
    const std::string& tag = drawing_.elements[index].tag;
    if (depth > deepest) {
      throw BadSketch(place_of(drawing_, drawing_.elements[index]) + ": it lies in more than " +
                          std::to_string(deepest) + " groups within each other",
                      "ungroup some of them");
    }
    const bool is_nested_page = tag == "svg" && depth > 0;
    if (is_nested_page) drawing_.elements[index].fault = "lies in a page within the page (a nested <svg>)";
    if (tag == "symbol" && node.attribute("viewBox"))
      drawing_.elements[index].fault = "lies in a symbol with a page of its own (viewBox)";
    const SvgElement inherited = drawing_.elements[index];
    for (const pugi::xml_node& child : node.children()) read(child, inherited, depth + 1, names);
    drawing_.elements[index].end = drawing_.elements.size();
  }

 private:
  SvgElement element(const pugi::xml_node& node, const SvgElement& around, const Namespaces& names) {
    SvgElement result;
    // Elements of other namespaces keep their whole name, and are no shapes.
    const XmlName name = names.name_of(node);
    result.tag = name.space == svg_space ? name.local : "other:" + std::string(name.local);
    result.id = node.attribute("id").value();
    result.label = label_of(node, names, result.id);
    const std::ptrdiff_t offset = node.offset_debug();
    const SourcePlace place_of_tag = places_.at(offset > 0 ? static_cast<std::size_t>(offset) - 1 : 0);
    result.line = place_of_tag.line;
    result.column = place_of_tag.column;
    result.drawn = around.drawn && name.space == svg_space && !is_container_of_what_is_not_drawn(result.tag);
    result.fault = around.fault;
    place(node, around, result);
    read_geometry(node, names, result);
    return result;
  }

  /// Inkscape's label, or the attribute in which other editors keep the name, because ids must be unique in the file.
  static std::string label_of(const pugi::xml_node& node, const Namespaces& names, const std::string& id) {
    std::string_view label = names.attribute(node, inkscape_space, "label");
    if (label.empty()) label = node.attribute("data-name").value();
    if (label.empty()) label = names.attribute(node, serif_space, "id");
    if (!label.empty()) return std::string(label);
    const std::string behind = name_behind(id);
    return behind == id ? std::string() : behind;
  }

  void place(const pugi::xml_node& node, const SvgElement& around, SvgElement& result) const {
    result.around = around.to_page;
    const auto own = parse_svg_transform(node.attribute("transform").value());
    if (!own) {
      result.fault = "has a transform that cannot be read";
    } else {
      result.to_page = around.to_page * *own;
      const SvgStyled styled{.tag = result.tag,
                             .id = result.id,
                             .classes = node.attribute("class").value(),
                             .style = node.attribute("style").value()};
      const std::string fault =
          node.attribute("transform-origin") ? "is moved by its style (CSS)" : style_fault(styled, rules_);
      if (!fault.empty()) result.fault = fault;
    }
    if (!(largest_stretch(result.to_page) <= 1e9)) result.fault = "is scaled beyond all measure";
  }

  static void read_geometry(const pugi::xml_node& node, const Namespaces& names, SvgElement& result) {
    const SvgAttribute attribute = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
    if (std::optional<SvgShape> shape = shape_of(result.tag, attribute)) {
      if (!shape->fault.empty()) {
        result.fault = shape->fault;
      } else if (shape->d.size() > max_path_bytes) {
        result.fault = "holds more than 256 KiB of path data";
      } else {
        result.d = std::move(shape->d);
      }
      result.center = shape->center;
    }
    if (result.tag != "image" && result.tag != "use") return;
    result.href = node.attribute("href").value();
    if (result.href.empty()) result.href = names.attribute(node, xlink_space, "href");
    result.position = {parse_svg_length(attribute("x")).value_or(0), parse_svg_length(attribute("y")).value_or(0)};
    constexpr std::array lengths{"x", "y", "width", "height"};
    const bool is_image = result.tag == "image";  // a clone has no size of its own
    const std::string fault = length_fault(std::span(lengths).first(is_image ? 4 : 2), attribute);
    if (!fault.empty()) result.fault = fault;
    if (!is_image) return;
    result.size = {parse_svg_length(attribute("width")).value_or(0), parse_svg_length(attribute("height")).value_or(0)};
    result.aspect = parse_svg_aspect(attribute("preserveAspectRatio"));
  }

  TextPlaces places_;
  std::vector<SvgStyleRule> rules_;
  SvgDrawing& drawing_;
};

/// Metres of one unit of the page: from a width in real units, and the viewBox if there is one.
std::optional<double> page_unit_of(const pugi::xml_node& root) {
  constexpr double pixel = 0.0254 / 96;
  const auto real = [&](const char* name) -> std::optional<double> {
    const std::string_view text = root.attribute(name).value();
    const bool has_unit = text.ends_with("mm") || text.ends_with("cm") || text.ends_with("in") ||
                          text.ends_with("pt") || text.ends_with("pc") || text.ends_with("Q");
    const std::optional<double> pixels = parse_svg_length(text);
    if (!has_unit || !pixels || !(*pixels > 0)) return {};
    return *pixels * pixel;
  };
  const std::optional<double> width = real("width"), height = real("height");
  const std::string_view view_box = root.attribute("viewBox").value();
  if (view_box.empty()) return width || height ? std::optional<double>(pixel) : std::nullopt;

  // The same grammar as a transform's numbers.
  const auto numbers = parse_svg_transform("matrix(" + std::string(view_box) + " 0 0)");
  if (!numbers) return {};
  const double box_width = numbers->c, box_height = numbers->d;
  std::optional<double> unit;
  if (width && box_width > 0) unit = *width / box_width;
  if (height && box_height > 0) {
    const double by_height = *height / box_height;
    const bool slices = parse_svg_aspect(root.attribute("preserveAspectRatio").value()).slices;
    unit = !unit ? by_height : slices ? std::max(*unit, by_height) : std::min(*unit, by_height);
  }
  return unit && *unit >= 1e-6 && *unit <= 1 ? unit : std::nullopt;
}

/// The size of the page must be lengths, and its viewBox four numbers, or the drawing would be of another size.
void check_page(const pugi::xml_node& root, const std::string& file) {
  const auto refuse = [&](const char* name, std::string_view text, const char* why) {
    throw BadSketch(
        at_place(file, 1, 1) + ": the page's " + name + " \"" + std::string(text.substr(0, 40)) + "\" " + why,
        "set the size of the page in the program it came from");
  };
  for (const char* name : {"width", "height"}) {
    const std::string_view text = root.attribute(name).value();
    constexpr std::string_view relative[] = {"%", "em", "ex", "ch", "rem", "vw", "vh", "vmin", "vmax", "auto"};
    if (text.empty() || std::any_of(std::begin(relative), std::end(relative),
                                    [&](std::string_view unit) { return text.ends_with(unit); }))
      continue;
    const std::optional<double> length = parse_svg_length(text);
    if (!length) refuse(name, text, "is no length");
    if (!(*length > 0)) refuse(name, text, "is not above 0");
  }
  const std::string_view box = root.attribute("viewBox").value();
  if (box.empty()) return;
  const auto numbers = parse_svg_transform("matrix(" + std::string(box) + " 0 0)");
  if (!numbers) refuse("viewBox", box, "is not four numbers");
  if (!(numbers->c > 0 && numbers->d > 0)) refuse("viewBox", box, "has no size");

  const std::string_view aspect = root.attribute("preserveAspectRatio").value();
  const std::optional<double> width = parse_svg_length(root.attribute("width").value());
  const std::optional<double> height = parse_svg_length(root.attribute("height").value());
  const bool keeps_shape = !width || !height || std::abs(*width / numbers->c * numbers->d / *height - 1) < 1e-3;
  if (!keeps_shape && parse_svg_aspect(aspect).stretches)
    refuse("preserveAspectRatio", aspect, "stretches the drawing");
}

void check_size(std::string_view text, const std::string& file) {
  if (text.size() > max_bytes) {
    throw BadSketch(at_place(file, 1, 1) + ": it is larger than 64 MiB",
                    "link the picture instead of embedding it, or make it smaller");
  }
  const auto many = [&](char c, std::size_t max) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), c)) > max;
  };
  if (many('<', 2 * max_elements) || many('=', max_attributes)) {
    throw BadSketch(at_place(file, 1, 1) + ": it holds more than " + std::to_string(max_elements) + " elements",
                    "keep the curves and the picture; delete what a tracer made");
  }
}

}  // namespace

std::string place_of(const SvgDrawing& drawing, const SvgElement& element) {
  return at_place(drawing.file, element.line, element.column);
}

SvgDrawing parse_svg(std::string_view text, const std::string& file) {
  // Compressed drawings and those that are too large are refused before they are parsed.
  if (text.starts_with("\x1f\x8b")) {
    throw BadSketch(at_place(file, 1, 1) + ": it is compressed (.svgz)",
                    "save it from Inkscape as \"Inkscape SVG\" (.svg)");
  }
  check_size(text, file);
  const std::size_t begin = text.starts_with("\xef\xbb\xbf") ? 3 : 0;  // behind the mark of UTF-8
  if (text.find_first_not_of(" \t\r\n", begin) != text.find('<'))
    throw BadSketch(at_place(file, 1, 1) + ": it is not XML: it does not begin with an element",
                    "save it from Inkscape as \"Inkscape SVG\"");

  // The text must be XML; errors are told by line and column.
  pugi::xml_document document;
  const unsigned options =
      pugi::parse_minimal | pugi::parse_escapes | pugi::parse_wconv_attribute | pugi::parse_cdata;  // style sheets
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
  if (!result) {
    const SourcePlace at = TextPlaces(text, file).at(static_cast<std::size_t>(result.offset));
    throw BadSketch(at_place(file, at.line, at.column) + ": it is not XML: " + result.description(),
                    "save it from Inkscape as \"Inkscape SVG\"");
  }

  // The drawing is made of the elements below the root.
  SvgDrawing drawing;
  drawing.file = file;
  const pugi::xml_node root = document.document_element();
  const XmlName name = Namespaces().within(root).name_of(root);
  if (name.space != svg_space || name.local != "svg") {
    throw BadSketch(at_place(file, 1, 1) + ": it is no SVG drawing: its first element is <" +
                        std::string(root.name()).substr(0, 40) + ">",
                    "save it from Inkscape as \"Inkscape SVG\"");
  }
  check_page(root, file);
  drawing.page_unit = page_unit_of(root);
  SvgReader(text, style_rules_of(document, file), drawing).read(root, {}, 0, {});
  return drawing;
}

}  // namespace pomona
