#include "render/deliver/model_files.h"

#include <utility>

#include "render/deliver/export_options.h"
#include "render/export/simulation/write_mjcf.h"
#include "render/export/simulation/write_urdf.h"

namespace pomona {

Delivered model_files(const Output& output, const Scene& scene, const Order& order, const DeliverOptions& how) {
  const ExportOptions options = export_options(order, how);
  Delivered delivered;
  if (output.format == Format::xml) {
    delivered.add(output.file, [&] { return write_mjcf(scene, options); });
    return delivered;
  }
  UrdfFiles made =
      delivered.times.time("write", [&] { return write_urdf(scene, output.file.stem().string(), options); });
  delivered.files.push_back({.file = {output.file, std::move(made.text)}});
  for (NamedFile& file : made.meshes)
    delivered.files.push_back({.file = {output.file.parent_path() / file.name, std::move(file.bytes)}});
  return delivered;
}

}  // namespace pomona
