// The JSON that the studio's page sends: one object of texts, numbers and truth values.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace pomona {

/// Null if the text is anything else: with objects or lists inside, or with more than 32 keys. Reading stops at the
/// first of these, so that a request takes little more memory than it has bytes: a tree of a list of empty lists takes
/// thirty times as much.
nlohmann::json parse_flat_json(const std::string& text);

}  // namespace pomona
