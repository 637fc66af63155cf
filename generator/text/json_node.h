// JSON as a plain tree in which every value knows its line and column.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"

namespace pomona {

struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  int line = 0, column = 0;
  std::shared_ptr<const std::string> file;  ///< name of the file, shared by all values
  double number = 0;
  std::string text;
  std::vector<JsonNode> items;    ///< items of an array or an object, in the order of the file
  std::vector<std::string> keys;  ///< keys of an object, one per item

  SourcePlace place() const { return {file ? *file : std::string(), line, column, {}}; }

  /// The value at a key of an object.
  /// \throws Error (bad_data) at this node if there is none.
  const JsonNode& need(std::string_view key) const;
};

constexpr std::size_t max_json_bytes = std::size_t{64} << 20;

/// Up to 64 MiB, 1 500 000 values (a layout of 100 000 pieces has 1 200 000), 1000 keys of an object and 32 levels,
/// within a quarter of a gigabyte.
/// \throws Error (bad_data) with line and column; duplicate keys are errors.
JsonNode parse_json(std::string_view text, const std::string& file);

}  // namespace pomona
