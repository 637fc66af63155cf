// The one file that knows toml++.
#include <algorithm>

#include <toml++/toml.h>

#include "generator/base/error.h"
#include "generator/text/toml_limits.h"
#include "generator/text/toml_node.h"
#include "generator/text/toml_syntax_hint.h"

namespace pomona {

namespace {

[[noreturn]] void fail(const std::string& file, TomlPlace place, std::string message, std::string hint = {}) {
  throw Error(ExitStatus::bad_data, {{{file, place.line, place.column, {}}, std::move(message), std::move(hint)}});
}

TomlPlace place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

/// Converts toml++'s tree to ours.
class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  TomlNode converted(const toml::node& node, int depth) const {
    TomlNode out;
    out.place = place_of(node.source());
    if (depth > TomlLimits{}.depth) {
      fail(file_, out.place, "tables nest deeper than " + std::to_string(TomlLimits{}.depth));
    }
    if (const auto* table = node.as_table()) {
      out.kind = TomlNode::Kind::table;
      fill_table(out, *table, depth);
    } else if (const auto* array = node.as_array()) {
      out.kind = TomlNode::Kind::array;
      for (const toml::node& item : *array) out.items.push_back(converted(item, depth + 1));
    } else {
      fill_value(out, node);
    }
    return out;
  }

 private:
  void fill_table(TomlNode& out, const toml::table& table, int depth) const {
    for (const auto& [key, value] : table) {
      out.entries.push_back({std::string(key.str()), place_of(key.source()), converted(value, depth + 1)});
    }
    std::stable_sort(out.entries.begin(), out.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
      return a.place.line != b.place.line ? a.place.line < b.place.line : a.place.column < b.place.column;
    });
  }

  static void fill_value(TomlNode& out, const toml::node& node) {
    if (const auto* text = node.as_string()) {
      out.kind = TomlNode::Kind::string;
      out.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
      out.kind = TomlNode::Kind::integer;
      out.integer = integer->get();
      out.number = static_cast<double>(integer->get());
    } else if (const auto* number = node.as_floating_point()) {
      out.kind = TomlNode::Kind::number;
      out.number = number->get();
    } else if (const auto* boolean = node.as_boolean()) {
      out.kind = TomlNode::Kind::boolean;
      out.boolean = boolean->get();
    } else {
      out.kind = TomlNode::Kind::date;
    }
  }

  const std::string& file_;
};

}  // namespace

TomlNode parse_toml(std::string_view text, const std::string& file) {
  if (const auto excess = find_excess(text)) fail(file, excess->place, excess->message);
  try {
    return Converter(file).converted(toml::parse(text, std::string_view(file)), 0);
  } catch (const toml::parse_error& error) {
    const TomlPlace place = place_of(error.source());
    fail(file, place, std::string(error.description()), toml_syntax_hint(text, place, error.description()));
  }
}

}  // namespace pomona
