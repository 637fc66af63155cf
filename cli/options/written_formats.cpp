#include "cli/options/written_formats.h"

#include "generator/base/error.h"

namespace pomona {

const std::vector<Format>& formats_of(OrderTaker taker) {
  static const std::vector<Format> of_fruit = {Format::ply,  Format::glb,    Format::usda, Format::obj,
                                               Format::stl,  Format::pov,    Format::png,  Format::svg,
                                               Format::html, Format::pomona, Format::xml,  Format::urdf};
  static const std::vector<Format> of_scene = {Format::ply,  Format::glb,  Format::usda, Format::obj,
                                               Format::stl,  Format::pov,  Format::png,  Format::svg,
                                               Format::json, Format::html, Format::xml,  Format::urdf};
  if (taker == OrderTaker::grow || taker == OrderTaker::cut) return of_fruit;
  if (taker == OrderTaker::scene) return of_scene;
  throw Error(ExitStatus::bug, "formats are asked for of a command that has none");
}

const std::vector<Format>& piece_formats() {
  static const std::vector<Format> formats = {Format::ply, Format::glb, Format::usda, Format::obj,
                                              Format::stl, Format::pov, Format::png,  Format::svg};
  return formats;
}

const std::vector<Format>& section_formats() {
  static const std::vector<Format> formats = {Format::ply, Format::png, Format::svg};
  return formats;
}

}  // namespace pomona
