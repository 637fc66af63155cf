#include "generator/template/read/read_grain_volume.h"

#include <string>
#include <vector>

#include "generator/template/curve_faults.h"
#include "generator/template/read/read_depth.h"
#include "generator/template/read/surface_names.h"

namespace pomona {

namespace {

constexpr double max_share = 0.5;  // more balls of chance do not fit into a volume

/// Notes what grains cannot fill.
void check_inside(const TomlValue& value, const SurfaceSketch& surface) {
  if (surface.type == SurfaceType::in_fold) {
    value.error("lies in folds; grains fill surfaces around the axis", "strew them over it with \"surface\"");
  } else if (fault_of_open_ends(surface.vertical)) {
    value.error("is open", "draw its vertical curve from the axis to the axis");
  }
}

void read_sizes(const TomlTable& table, GrainVolume& volume) {
  const Within size{1e-4, 0.2};
  volume.from = table.need("from").length(volume.from, size);
  const TomlValue to = table.need("to");
  volume.to = to.length(volume.to, size);
  if (volume.to < volume.from) to.error("is less than \"from\"", "write the smallest size as \"from\"");
  volume.exponent = table.get("exponent").number(volume.exponent, {0, 8});
  volume.share = table.need("share").number(volume.share, {1e-4, max_share});
  volume.near_skin = read_depth_ramp(table.get("near_skin"), 1, {0, 1});
}

/// Length, width and thickness of a grain of size 1.
void read_proportions(const TomlValue& value, double size, GrainForm& form) {
  form.length = form.width = form.thickness = size;
  const auto shares = value.values(3, "must be length, width and thickness over the size, as in [1.3, 1, 0.8]");
  if (shares.empty()) return;
  const Within within{0.1, 3};
  form.length *= shares[0].number(1, within);
  form.width *= shares[1].number(1, within);
  form.thickness *= shares[2].number(1, within);
}

}  // namespace

void read_grain_volume(const TomlTable& table, const Template& fruit, GrainSketch& grain) {
  const std::vector<std::string> names = surface_names(fruit);
  const TomlValue inside = table.need("inside");
  grain.surface = inside.choice(names);
  if (const auto at = static_cast<std::size_t>(grain.surface); at < fruit.surfaces.size())
    check_inside(inside, fruit.surfaces[at]);

  GrainVolume volume;
  read_sizes(table.need("sizes").table(), volume);
  read_proportions(table.get("proportions"), volume.to, grain.form);
  volume.heading =
      static_cast<GrainVolume::Heading>(table.get("heading").choice({"any", "along", "out", "up", "around"}));
  volume.stray = table.get("stray").angle(0, {0, 90});
  volume.wall = table.get("wall").length(1e-4, {1e-5, 0.1});
  volume.apart = table.get("apart").length(1e-4, {1e-5, 0.1});
  volume.lumps = table.get("lumps").number(0, {0, 0.6});
  if (table.has("clear_of")) {
    for (const TomlValue& name : table.get("clear_of").values()) volume.clear_of.push_back(name.choice(names));
  }
  grain.volume = volume;
}

}  // namespace pomona
