#include "generator/template/read_paint.h"

namespace pomona {

namespace {

Ramp<Color> read_color_ramp(const TomlValue& value, const Color& fallback) {
  return read_ramp<Color>(value, fallback, [](const TomlValue& stop) { return stop.color(); });
}

}  // namespace

PaintedColor read_painted_color(const TomlValue& value) {
  PaintedColor color;
  if (value.is(TomlNode::Kind::table)) {
    const TomlTable table = value.table();
    const TomlValue sample = table.get("sample");
    if (sample.given() && !table.has("along")) {
      sample.error("has no colours yet",
                   "`pomona sketch FILE --sample` takes them from the picture and writes them here");
    } else {
      color.along = read_color_ramp(table.need("along"), Color(0.5f));
    }
    if (sample.given() && !sample.text().starts_with("#")) sample.error("names no line", "write \"#\" and its name");
    table.get("stops").integer(9, 2, 64);
    color.around = read_color_ramp(table.get("around"), Color(1.0f));
  } else {
    color.along = read_color_ramp(value, Color(0.5f));
  }
  return color;
}

Side read_side(const TomlTable& table, const std::vector<std::string>& parts) {
  Side side;
  const TomlValue part = table.need("part");
  if (!parts.empty()) side.part = part.choice(parts);  // with none known, that is the one mistake to report
  side.color = read_painted_color(table.need("color"));
  side.hidden = table.get("hidden").boolean(false);
  return side;
}

}  // namespace pomona
