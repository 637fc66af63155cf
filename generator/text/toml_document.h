// Reads a TOML file and reports all its mistakes at once: typed access notes mistakes, with line and column, and goes
// on with a harmless value.
//
//   TomlDocument document(text, "tomato.toml");
//   const TomlTable root = document.root();
//   fruit.title = root.need("title").text();
//   for (const TomlTable& surface : root.get("surface").tables()) {
//     sketch.blur = surface.get("blur").length(0.0, {0, 0.005});
//   }
//   document.throw_if_any();
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/color.h"
#include "generator/base/error.h"
#include "generator/text/toml_node.h"

namespace pomona {

class TomlTable;
struct TomlState;

/// The range of a number, ends included.
struct Within {
  double low = -1e6;
  double high = 1e6;
};

/// A value at a key or in an array, which may be missing. Every reader below returns the fallback for a missing value
/// (need() has reported it already), and notes a mistake for one that does not fit. Values and tables point into their
/// document and must not outlive it.
class TomlValue {
 public:
  bool given() const { return node_ != nullptr; }
  bool is(TomlNode::Kind kind) const { return node_ && node_->kind == kind; }

  std::string text(const std::string& fallback = {}) const;
  bool boolean(bool fallback = false) const;
  int integer(int fallback, int low, int high) const;
  double number(double fallback = 0, Within within = {}) const;
  double length(double fallback = 0, Within metres = {}) const;  ///< "4mm" in metres; the unit is required
  double angle(double fallback = 0,
               Within degrees = {}) const;                 ///< the file has degrees; fallback and result are radians
  Color color(const Color& fallback = Color(0.5f)) const;  ///< "#rrggbb" as linear RGB

  /// The index of one of the names; the message lists them.
  int choice(const std::vector<std::string>& names, int fallback = 0) const;

  std::vector<TomlValue> values() const;  ///< the values of an array
  /// The values of an array that must have so many; none if it has others, which is noted with `fault` and `hint`.
  std::vector<TomlValue> values(std::size_t count, const std::string& fault, const std::string& hint = {}) const;
  /// The tables of an array; more than `max` are a mistake, and left out.
  std::vector<TomlTable> tables(std::size_t max = SIZE_MAX) const;
  TomlTable table() const;  ///< if there is none, an empty table that reports nothing

  /// Notes a mistake of this value: "surface "skin": blur <message>".
  void error(const std::string& message, const std::string& hint = {}) const;
  /// Its place in the file; line 0 if it is missing.
  SourcePlace place() const;
  /// The value's name in messages: `surface "skin": front color`.
  std::string name() const;

 private:
  friend class TomlTable;
  friend class TomlDocument;
  TomlValue(TomlNode* node, TomlState* state, std::string path);
  bool expect(TomlNode::Kind kind, const char* what) const;
  double checked(double value, Within within, double fallback) const;

  TomlNode* node_;    ///< null if the value is missing
  TomlState* state_;  ///< state of the document
  std::string path_;
};

/// A table. throw_if_any() reports keys that nobody has read as unknown, with the most similar known one.
class TomlTable {
 public:
  bool given() const { return value_.given(); }
  bool has(std::string_view key) const { return get(key).given(); }
  TomlValue get(std::string_view key) const;
  /// The same, but a missing key is a mistake of the table.
  TomlValue need(std::string_view key) const;
  /// The keys of the table, for tables with free names; the caller reads them.
  std::vector<std::string> keys() const;

  /// The same table, with another name in messages: `surface "skin"`.
  TomlTable called(const std::string& label) const;
  void error(const std::string& message, const std::string& hint = {}) const { value_.error(message, hint); }

 private:
  friend class TomlValue;
  friend class TomlDocument;
  explicit TomlTable(TomlValue value);
  TomlEntry* find(std::string_view key) const;
  TomlValue value_;
};

class TomlDocument {
 public:
  /// \throws Error (bad_data) for text that is not TOML or goes beyond the limits of toml_node.h.
  TomlDocument(std::string_view text, const std::string& file);
  ~TomlDocument();
  TomlDocument(const TomlDocument&) = delete;
  TomlDocument& operator=(const TomlDocument&) = delete;

  TomlTable root() const;

  /// Call it when all has been read: adds the unknown keys and throws one Error (bad_data) with the first 20 mistakes
  /// by position, if there are any.
  void throw_if_any();

  /// The same without unknown keys, for callers that read only some of the file.
  void throw_if_noted();

 private:
  std::unique_ptr<TomlState> state_;
};

}  // namespace pomona
