#include "generator/template/read/read_paint.h"

#include "generator/template/read/read_spots.h"

namespace pomona {

namespace {

constexpr std::size_t most_coats = 32;

Color read_color(const TomlValue& value) { return value.color(); }
double read_share(const TomlValue& value) { return value.number(1, {0, 1}); }

Ramp<Color> read_color_ramp(const TomlValue& value, const Color& fallback) {
  return read_ramp<Color>(value, fallback, read_color);
}

/// One value for each fold, or for the first ones; they are taken in turn.
template <typename Value, typename Read>
std::vector<Value> read_folds(const TomlValue& value, int folds, Read read) {
  if (!value.given()) return {};
  const std::vector<TomlValue> given = value.values();
  if (folds == 0) {
    value.error("speaks of folds, but the fruit has none", "use \"turn\"");
  } else if (given.size() > static_cast<std::size_t>(folds)) {
    value.error("has " + std::to_string(given.size()) + " values for " + std::to_string(folds) + " folds",
                "write one for each fold; fewer are taken in turn");
  } else if (given.empty() && value.is(TomlNode::Kind::array)) {
    value.error("is empty", "write one value for each fold");
  }
  std::vector<Value> result;
  for (std::size_t k = 0; k < std::min<std::size_t>(given.size(), 64); ++k) result.push_back(read(given[k]));
  return result;
}

void read_sampled_along(const TomlTable& table, PaintedColor& color) {
  const TomlValue sample = table.get("sample");
  if (sample.given() && !table.has("along")) {
    sample.error("has no colours yet",
                 "`pomona sketch FILE --sample` takes them from the picture and writes them here");
  } else {
    color.along = read_color_ramp(table.need("along"), Color(0.5f));
  }
  if (sample.given() && !sample.text().starts_with("#")) sample.error("names no line", "write \"#\" and its name");
  table.get("stops").integer(9, 2, 64);
}

PaintedColor read_painted_color(const TomlValue& value, const PaintedSurface* surface) {
  PaintedColor color;
  if (!value.is(TomlNode::Kind::table)) {
    color.along = read_color_ramp(value, Color(0.5f));
    return color;
  }
  const TomlTable table = value.table();
  read_sampled_along(table, color);
  color.around = read_color_ramp(table.get("around"), Color(1.0f));
  if (surface) {
    color.turn = read_turn<Color>(table.get("turn"), Color(1.0f), read_color);
    color.folds = read_folds<Color>(table.get("folds"), surface->folds, read_color);
  }
  return color;
}

Coat read_coat(const TomlTable& table, const PaintedSurface& surface) {
  Coat coat;
  coat.color = read_color_ramp(table.need("color"), Color(0.5f));
  coat.along = read_ramp<double>(table.get("along"), 1.0, read_share);
  coat.around = read_ramp<double>(table.get("around"), 1.0, read_share);
  coat.turn = read_turn<double>(table.get("turn"), 1.0, read_share);
  coat.folds = read_folds<double>(table.get("folds"), surface.folds, read_share);
  return coat;
}

Side read_any_side(const TomlTable& table, const std::vector<std::string>& parts, const PaintedSurface* surface) {
  Side side = read_uncolored_side(table, parts);
  side.color = read_painted_color(table.need("color"), surface);
  return side;
}

}  // namespace

PaintedBlur read_painted_blur(const TomlValue& value) {
  const auto length = [](const TomlValue& stop) { return stop.length(0, {0, 0.1}); };
  if (!value.is(TomlNode::Kind::table)) return read_ramp<double>(value, 0.0, length);
  const TomlTable table = value.table();
  PaintedBlur blur;
  blur.along = read_ramp<double>(table.need("along"), 0.0, length);
  blur.around = read_ramp<double>(table.get("around"), 1.0, read_share);
  blur.turn = read_turn<double>(table.get("turn"), 1.0, read_share);
  return blur;
}

Side read_uncolored_side(const TomlTable& table, const std::vector<std::string>& parts) {
  Side side;
  const TomlValue part = table.need("part");
  if (!parts.empty()) side.part = part.choice(parts);  // with none known, that is the one mistake to report
  side.hidden = table.get("hidden").boolean(false);
  return side;
}

Side read_side(const TomlTable& table, const std::vector<std::string>& parts) {
  return read_any_side(table, parts, nullptr);
}

PaintedColor read_painted_color(const TomlValue& value) { return read_painted_color(value, nullptr); }

Side read_surface_side(const TomlTable& table, const std::vector<std::string>& parts, const PaintedSurface& surface) {
  Side side = read_any_side(table, parts, &surface);
  for (const TomlTable& coat : table.get("coats").tables(most_coats)) side.coats.push_back(read_coat(coat, surface));
  side.spots = read_spots(table.get("spots"), surface.type, side.hidden);
  return side;
}

}  // namespace pomona
