// A TOML text as a plain tree in which every key and value knows its line and column. toml_document.h reads it with
// types and messages; this part knows the parser.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// Line and column, both from 1.
struct TomlPlace {
  int line = 0;
  int column = 0;
};

struct TomlEntry;

struct TomlNode {
  enum class Kind { string, integer, number, boolean, date, array, table };

  Kind kind = Kind::table;
  TomlPlace place;
  std::string text;   ///< text of a string
  double number = 0;  ///< value of an integer or a number; may be infinite or NaN
  std::int64_t integer = 0;
  bool boolean = false;
  std::vector<TomlNode> items;     ///< items of an array
  std::vector<TomlEntry> entries;  ///< entries of a table, in the order of the file

  // Set by toml_document.h, to find keys that nobody has read.
  bool opened = false;
  std::vector<std::string> asked;
};

struct TomlEntry {
  std::string key;
  TomlPlace place;
  TomlNode value;
};

/// Parses within the limits that docs/reference/formats.md states: 16 MiB, UTF-8, depth 64, 100 000 values in an array,
/// 1 000 000 in all, 64 KiB in a string. They are checked before the parser runs, so that it cannot exhaust stack or
/// memory. Duplicate keys are errors.
/// \throws Error (bad_data) at the first mistake of syntax.
TomlNode parse_toml(std::string_view text, const std::string& file);

}  // namespace pomona
