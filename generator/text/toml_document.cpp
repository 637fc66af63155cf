#include "generator/text/toml_document.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/base/nearest_name.h"
#include "generator/base/number_text.h"
#include "generator/base/units.h"

namespace pomona {

struct TomlState {
  std::string file;
  TomlNode root;
  std::vector<Diagnostic> diagnostics;

  void note(TomlPlace place, const std::string& message, const std::string& hint) {
    diagnostics.push_back({{file, place.line, place.column, {}}, message, hint});
  }
};

namespace {

constexpr std::size_t max_diagnostics = 20;  ///< limit of mistakes that are listed

std::string joined(const std::string& path, const std::string& key) {
  if (path.empty() || path.ends_with(": ")) return path + key;
  return path + " " + key;
}

/// A text as messages quote it; long texts are cut.
std::string quoted(const std::string& text) {
  constexpr std::size_t max = 40;
  if (text.size() <= max) return "\"" + text + "\"";
  std::size_t end = max;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  return "\"" + text.substr(0, end) + "...\"";
}

const char* kind_name(TomlNode::Kind kind) {
  switch (kind) {
    case TomlNode::Kind::string:
      return "a text";
    case TomlNode::Kind::integer:
      return "a whole number";
    case TomlNode::Kind::number:
      return "a number";
    case TomlNode::Kind::boolean:
      return "true or false";
    case TomlNode::Kind::date:
      return "a date";
    case TomlNode::Kind::array:
      return "an array";
    case TomlNode::Kind::table:
      break;
  }
  return "a table";
}

/// Reports the keys that nobody has read in every opened table.
void note_unknown(const TomlNode& node, TomlState& state) {
  for (const TomlEntry& entry : node.entries) {
    const bool known = std::find(node.asked.begin(), node.asked.end(), entry.key) != node.asked.end();
    if (node.opened && !known) {
      state.note(entry.place, "unknown key " + quoted(entry.key), name_hint(entry.key, node.asked));
    }
    if (known) note_unknown(entry.value, state);
  }
  for (const TomlNode& item : node.items) note_unknown(item, state);
}

}  // namespace

// ---- TomlValue ----

TomlValue::TomlValue(TomlNode* node, TomlState* state, std::string path)
    : node_(node), state_(state), path_(std::move(path)) {}

std::string TomlValue::name() const { return path_.empty() ? "the file" : path_; }

SourcePlace TomlValue::place() const {
  if (!node_) return {state_ ? state_->file : std::string(), 0, 0, {}};
  return {state_->file, node_->place.line, node_->place.column, {}};
}

void TomlValue::error(const std::string& message, const std::string& hint) const {
  if (!node_) return;
  state_->note(node_->place, joined(name(), message), hint);
}

bool TomlValue::expect(TomlNode::Kind kind, const char* what) const {
  if (!node_) return false;
  if (node_->kind == kind) return true;
  error(std::string("must be ") + what + ", not " + kind_name(node_->kind));
  return false;
}

std::string TomlValue::text(const std::string& fallback) const {
  return expect(TomlNode::Kind::string, "a text in quotes") ? node_->text : fallback;
}

bool TomlValue::boolean(bool fallback) const {
  return expect(TomlNode::Kind::boolean, "true or false") ? node_->boolean : fallback;
}

int TomlValue::integer(int fallback, int low, int high) const {
  if (!expect(TomlNode::Kind::integer, "a whole number")) return fallback;
  if (node_->integer >= low && node_->integer <= high) return static_cast<int>(node_->integer);
  error("is " + std::to_string(node_->integer) + ", but must lie between " + std::to_string(low) + " and " +
        std::to_string(high));
  return fallback;
}

double TomlValue::checked(double value, Within within, double fallback) const {
  if (value >= within.low && value <= within.high) return value;  // false for NaN
  error("is " + number_text(value) + ", but must lie between " + number_text(within.low) + " and " +
        number_text(within.high));
  return fallback;
}

double TomlValue::number(double fallback, Within within) const {
  if (!is(TomlNode::Kind::integer) && !expect(TomlNode::Kind::number, "a number")) return fallback;
  return checked(node_->number, within, fallback);
}

double TomlValue::angle(double fallback, Within degrees) const {
  if (!is(TomlNode::Kind::integer) && !expect(TomlNode::Kind::number, "an angle in degrees")) return fallback;
  if (!(node_->number >= degrees.low && node_->number <= degrees.high)) {
    return checked(node_->number, degrees, fallback);
  }
  return radians(node_->number);
}

double TomlValue::length(double fallback, Within metres) const {
  constexpr const char* what = "a length with its unit, as in \"4mm\"";
  if (!expect(TomlNode::Kind::string, what)) return fallback;
  const std::optional<double> value = node_->text.ends_with("m") ? parse_length(node_->text) : std::nullopt;
  if (!value) {
    error(quoted(node_->text) + " is not " + what, "units are mm, cm and m");
    return fallback;
  }
  if (*value >= metres.low && *value <= metres.high) return *value;
  error("is " + node_->text + ", but must lie between " + number_text(metres.low * 1000) + "mm and " +
        number_text(metres.high * 1000) + "mm");
  return fallback;
}

Color TomlValue::color(const Color& fallback) const {
  if (!expect(TomlNode::Kind::string, "a colour, \"#rrggbb\"")) return fallback;
  if (const std::optional<Color> color = parse_color(node_->text)) return *color;
  error(quoted(node_->text) + " is not a colour", "write six hexadecimal digits, as in \"#c8102e\"");
  return fallback;
}

int TomlValue::choice(const std::vector<std::string>& names, int fallback) const {
  if (!expect(TomlNode::Kind::string, "a text in quotes")) return fallback;
  const auto found = std::find(names.begin(), names.end(), node_->text);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  error(quoted(node_->text) + " is not known", name_hint(node_->text, names));
  return fallback;
}

std::vector<TomlValue> TomlValue::values() const {
  std::vector<TomlValue> values;
  if (!expect(TomlNode::Kind::array, "an array")) return values;
  for (TomlNode& item : node_->items) {
    values.push_back(TomlValue(&item, state_, joined(path_, "no. " + std::to_string(values.size() + 1))));
  }
  return values;
}

std::vector<TomlValue> TomlValue::values(std::size_t count, const std::string& fault, const std::string& hint) const {
  std::vector<TomlValue> values = this->values();
  if (values.size() == count) return values;
  if (is(TomlNode::Kind::array)) error(fault, hint);
  return {};
}

std::vector<TomlTable> TomlValue::tables(std::size_t max) const {
  std::vector<TomlTable> tables;
  for (const TomlValue& value : values()) tables.push_back(value.table());
  if (tables.size() > max) {
    error("is there " + std::to_string(tables.size()) + " times; the most is " + std::to_string(max));
    tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(max), tables.end());
  }
  return tables;
}

TomlTable TomlValue::table() const {
  const bool is_table = expect(TomlNode::Kind::table, "a table");
  return TomlTable(TomlValue(is_table ? node_ : nullptr, state_, path_));
}

// ---- TomlTable ----

TomlTable::TomlTable(TomlValue value) : value_(std::move(value)) {
  if (value_.node_) value_.node_->opened = true;
}

TomlEntry* TomlTable::find(std::string_view key) const {
  if (!value_.node_) return nullptr;
  std::vector<std::string>& asked = value_.node_->asked;
  if (std::find(asked.begin(), asked.end(), key) == asked.end()) asked.emplace_back(key);
  for (TomlEntry& entry : value_.node_->entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

TomlValue TomlTable::get(std::string_view key) const {
  TomlEntry* entry = find(key);
  return TomlValue(entry ? &entry->value : nullptr, value_.state_, joined(value_.path_, std::string(key)));
}

TomlValue TomlTable::need(std::string_view key) const {
  const TomlValue value = get(key);
  if (!value.given()) value_.error("lacks \"" + std::string(key) + "\"");
  return value;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  if (!value_.node_) return keys;
  for (const TomlEntry& entry : value_.node_->entries) keys.push_back(entry.key);
  return keys;
}

TomlTable TomlTable::called(const std::string& label) const {
  return TomlTable(TomlValue(value_.node_, value_.state_, label + ": "));
}

// ---- TomlDocument ----

TomlDocument::TomlDocument(std::string_view text, const std::string& file) : state_(std::make_unique<TomlState>()) {
  state_->file = file;
  state_->root = parse_toml(text, file);
  // The file as a whole is its first line, where people look for what is missing.
  state_->root.place = {1, 1};
}

TomlDocument::~TomlDocument() = default;

TomlTable TomlDocument::root() const { return TomlTable(TomlValue(&state_->root, state_.get(), {})); }

void TomlDocument::throw_if_any() {
  note_unknown(state_->root, *state_);
  throw_if_noted();
}

void TomlDocument::throw_if_noted() {
  std::vector<Diagnostic> found = std::move(state_->diagnostics);
  if (found.empty()) return;
  std::stable_sort(found.begin(), found.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line : a.place.column < b.place.column;
  });
  if (found.size() > max_diagnostics) found.resize(max_diagnostics);
  throw Error(ExitStatus::bad_data, std::move(found));
}

}  // namespace pomona
