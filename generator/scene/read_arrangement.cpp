#include "generator/scene/read_arrangement.h"

#include <string>
#include <vector>

namespace pomona {

namespace {

constexpr Within within_reach{-100, 100};  // metres
constexpr Within size_of_where{0, 10};

glm::dvec2 read_two(const TomlValue& value, Within within) {
  glm::dvec2 two(0);
  if (!value.given()) return two;
  const std::vector<TomlValue> parts = value.values();
  if (parts.size() != 2) {
    if (value.is(TomlNode::Kind::array)) value.error("needs two lengths", "write [\"10cm\", \"-5cm\"]");
    return two;
  }
  return {parts[0].length(0, within), parts[1].length(0, within)};
}

}  // namespace

PieceArrangement read_arrangement(const TomlTable& table) {
  // The order of the names is that of the kinds.
  static const std::vector<std::string> kinds{"heap", "rows", "grid", "scatter", "as-cut"};
  PieceArrangement how;
  how.kind = static_cast<PieceArrangementKind>(table.need("kind").choice(kinds));
  how.at = read_two(table.get("at"), within_reach);
  how.turn = table.get("turn").angle(0, {-360, 360});
  switch (how.kind) {
    case PieceArrangementKind::heap:
      how.within = table.get("within").length(0, size_of_where);
      if (table.has("at") && how.within <= 0)
        table.get("at").error("needs \"within\", too", "say how wide the heap is");
      break;
    case PieceArrangementKind::rows:
      how.columns = table.get("columns").integer(0, 1, 10000);
      how.gap = table.get("gap").length(how.gap, size_of_where);
      break;
    case PieceArrangementKind::grid:
      how.columns = table.get("columns").integer(0, 1, 10000);
      how.spacing = read_two(table.need("spacing"), {1e-3, 10});
      break;
    case PieceArrangementKind::scatter:
      how.gap = table.get("gap").length(how.gap, size_of_where);
      break;
    case PieceArrangementKind::as_cut:
      how.gap = table.get("gap").length(how.gap, size_of_where);
      how.line = table.get("line").length(0, size_of_where);
      how.lean = table.get("lean").angle(how.lean, {0, 60});
      break;
  }
  return how;
}

}  // namespace pomona
