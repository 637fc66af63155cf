#include "generator/template/read/read_variation.h"

namespace pomona {

namespace {

BendVariation read_bend_variation(const TomlTable& table) {
  BendVariation bend;
  bend.angle = table.get("angle").angle(0, {0, 45});
  bend.swing = table.get("swing").angle(0, {0, 45});
  bend.around = table.get("around").boolean(false);
  return bend;
}

}  // namespace

VariationSketch read_variation(const TomlTable& table) {
  VariationSketch variation;
  variation.size = table.get("size").number(0, {0, 0.25});
  variation.profile = table.get("profile").number(0, {0, 0.25});
  if (table.has("bend")) variation.bend = read_bend_variation(table.get("bend").table());
  return variation;
}

AxisBend read_bend(const TomlTable& table) {
  AxisBend bend;
  bend.angle = table.get("angle").angle(0, {-150, 150});
  bend.swing = table.get("swing").angle(0, {-150, 150});
  bend.direction = table.get("direction").angle(0, {-360, 360});
  return bend;
}

}  // namespace pomona
