// Reading a TOML file so that its author learns everything that is wrong with it at once: typed access that
// notes mistakes, with line and column, and goes on with a harmless value. Templates and scenes use it.
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

/// The values a number may have, ends included.
struct Within {
  double low = -1e6;
  double high = 1e6;
};

/// A value at a key or in an array, there or not. Every reader below returns the fallback for a value that is
/// not there (need() has complained already), and notes a diagnostic for one that does not fit.
/// Values and tables point into their document and must not outlive it.
class TomlValue {
 public:
  bool given() const { return node_ != nullptr; }
  bool is(TomlNode::Kind kind) const { return node_ && node_->kind == kind; }

  std::string text(const std::string& fallback = {}) const;
  bool boolean(bool fallback = false) const;
  int integer(int fallback, int low, int high) const;
  double number(double fallback = 0, Within within = {}) const;
  double length(double fallback = 0, Within metres = {}) const;  ///< "4mm" as metres; the unit is a must
  double angle(double fallback = 0,
               Within degrees = {}) const;                 ///< degrees in the file; fallback and result in radians
  Color color(const Color& fallback = Color(0.5f)) const;  ///< "#rrggbb" as linear RGB

  /// One of the names, as its index; the message lists them.
  int choice(const std::vector<std::string>& names, int fallback = 0) const;

  std::vector<TomlValue> values() const;  ///< of an array
  /// Of an array of tables; more than `max` are an error, and left out.
  std::vector<TomlTable> tables(std::size_t max = SIZE_MAX) const;
  TomlTable table() const;  ///< where there is none, an empty one that never complains

  /// Notes something wrong with this value: "surface "skin": blur <message>".
  void error(const std::string& message, const std::string& hint = {}) const;
  /// Where it stands in its file; line 0 if it is not there.
  SourcePlace place() const;
  /// The value's name in messages: `surface "skin": front color`.
  std::string name() const;

 private:
  friend class TomlTable;
  friend class TomlDocument;
  TomlValue(TomlNode* node, TomlState* state, std::string path);
  bool expect(TomlNode::Kind kind, const char* what) const;
  double checked(double value, Within within, double fallback) const;

  TomlNode* node_;    ///< null: not there
  TomlState* state_;  ///< the document's
  std::string path_;
};

/// A table. Keys nobody asks for are reported by throw_if_any() as unknown, with the nearest known one.
class TomlTable {
 public:
  bool given() const { return value_.given(); }
  bool has(std::string_view key) const { return get(key).given(); }
  TomlValue get(std::string_view key) const;
  /// The same, but where the key is missing that is noted at the table that should hold it.
  TomlValue need(std::string_view key) const;
  /// The keys that are there, for tables with free names; asking for them is left to the caller.
  std::vector<std::string> keys() const;

  /// The same table, by another name in messages: `surface "skin"`.
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
  bool has_errors() const;

  /// To be called when all has been read: adds the unknown keys and throws one Error (bad_data) with the
  /// first 20 diagnostics by position, or returns.
  void throw_if_any();

  /// The same without the unknown keys, for who reads only some of the file.
  void throw_if_noted();

 private:
  std::unique_ptr<TomlState> state_;
};

}  // namespace pomona
