#include "render/deliver/export_options.h"

#include "generator/order/option_table.h"

namespace pomona {

ExportOptions export_options(const Order& order, const DeliverOptions& how) {
  // A piece's own origin says how it grew and was cut.
  Order look;
  look.color = order.color;
  look.mesh = order.mesh;
  return {.style = how.style,
          .provenance = made_by(how.provenance),
          .command_words = piece_words(look),
          .threads = order.threads,
          .instances = order.mesh.instances,
          .feature_ids = order.mesh.feature_ids,
          .engine = order.mesh.engine,
          .compress = order.mesh.compress,
          .up = order.mesh.up,
          .hulls = order.mesh.hulls,
          .welded = order.mesh.welded,
          .atlas = atlas_of(order.mesh)};
}

std::optional<BakeOptions> bake_options(const Order& order) {
  if (!wants_textures(order.mesh)) return {};
  // Maps are for .glb; and for .usda where they take the place of materials.
  const bool has_atlas = atlas_of(order.mesh) != AtlasOf::none;
  const bool takes_maps = any_is(order.outputs, {Format::glb}) || (has_atlas && any_is(order.outputs, {Format::usda}));
  const bool has_maps = order.mesh.maps == Maps::all && takes_maps;
  BakeOptions how{.texel = order.mesh.texel.metres,
                  .maps = has_maps ? Maps::all : Maps::color,
                  .looks = has_maps && has_atlas,
                  .threads = order.threads};
  if (order.mesh.texture > 0) how.texels = order.mesh.texture;
  return how;
}

}  // namespace pomona
