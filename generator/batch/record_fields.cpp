#include "generator/batch/record_fields.h"

namespace pomona {

void refuse_record(const SourcePlace& place, const std::string& message, const std::string& hint) {
  throw Error(ExitStatus::bad_data, {{place, message, hint}});
}

std::string text_at(const JsonNode& node, std::string_view key, const std::string& hint) {
  const JsonNode& value = node.need(key);
  if (value.kind != JsonNode::Kind::string) refuse_record(value.place(), "should be a text", hint);
  return value.text;
}

}  // namespace pomona
