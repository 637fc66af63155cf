#include "render/deliver/map_files.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "render/image/png.h"

namespace pomona {

std::vector<OutputFile> map_files(std::span<const BakedSolid> baked, const std::filesystem::path& folder) {
  std::vector<OutputFile> files;
  nlohmann::ordered_json parts = nlohmann::ordered_json::object();
  for (const BakedSolid& solid : baked) {
    if (solid.texture.pixels.empty()) continue;
    std::string name = solid.solid.name;
    std::replace(name.begin(), name.end(), '/', '_');
    const auto add = [&](const char* map, const Image& image, PngValues values) {
      if (image.pixels.empty()) return;
      files.push_back({folder / (name + "." + map + ".png"), write_png(image, PngPacking::fast, values)});
    };
    add("color", solid.texture, PngValues::srgb);
    add("normal", solid.maps.normal, PngValues::shares);
    add("orm", solid.maps.orm, PngValues::shares);
    add("thickness", solid.maps.thickness, PngValues::shares);
    add("part", solid.maps.part, PngValues::shares);
    parts[name] = solid.solid.look->part_names;
  }
  files.push_back({folder / "parts.json", json_text(parts, 2) + "\n"});
  return files;
}

}  // namespace pomona
