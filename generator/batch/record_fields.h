// The fields of records that batches leave: files that pomona has written, and somebody may have touched.
#pragma once

#include <string>
#include <string_view>

#include "generator/text/json_node.h"

namespace pomona {

/// \throws Error (bad_data) with the place, the message and the hint.
[[noreturn]] void refuse_record(const SourcePlace& place, const std::string& message, const std::string& hint);

/// \param hint what to do about a record that is wrong. \throws Error (bad_data) if there is no text.
std::string text_at(const JsonNode& node, std::string_view key, const std::string& hint);

}  // namespace pomona
