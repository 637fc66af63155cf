#include "generator/text/one_or_many.h"

namespace pomona {

std::vector<TomlValue> one_or_many(const TomlValue& value) {
  if (!value.given()) return {};
  if (!value.is(TomlNode::Kind::array)) return {value};
  std::vector<TomlValue> values = value.values();
  if (values.empty()) value.error("is empty", "leave it out, or write at least one");
  return values;
}

}  // namespace pomona
