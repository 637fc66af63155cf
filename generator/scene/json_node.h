// JSON as a plain tree in which every value knows its line and column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"

namespace pomona {

struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  SourcePlace place;
  double number = 0;
  std::string text;
  std::vector<JsonNode> items;    ///< of an array or an object, in the order of the file
  std::vector<std::string> keys;  ///< of an object, one per item

  /// The value at a key of an object. \throws Error (bad_data) at this node where there is none.
  const JsonNode& need(std::string_view key) const;
};

/// Up to 64 MiB and 32 levels. \throws Error (bad_data) with line and column; duplicate keys are errors.
JsonNode parse_json(std::string_view text, const std::string& file);

}  // namespace pomona
