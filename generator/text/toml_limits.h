// Limits of TOML texts, checked by a scanner without recursion.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "generator/text/toml_node.h"

namespace pomona {

struct TomlLimits {
  std::size_t bytes = std::size_t{16} << 20;
  int depth = 64;                     ///< depth of brackets, and number of dots in one key
  std::size_t array_values = 100000;  ///< in one array or inline table
  std::size_t values = 1000000;       ///< in the whole file
  std::size_t string_bytes = 65536;
};

struct TomlExcess {
  TomlPlace place;
  std::string message;
};

/// The first place where the text exceeds a limit or is not UTF-8, if any. Text that is not TOML may pass; the parser
/// reports it.
std::optional<TomlExcess> find_excess(std::string_view text, const TomlLimits& limits = {});

}  // namespace pomona
