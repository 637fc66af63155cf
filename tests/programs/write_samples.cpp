// Writes the exporters' named scenes into a folder, for other programs to read.
//   write_samples FOLDER
#include <filesystem>

#include "render/export/gltf/write_glb.h"
#include "render/export/output.h"
#include "render/style/style_file.h"
#include "tests/render/export/named_solids.h"

int main(int, char** arguments) {
  using namespace pomona;
  const std::filesystem::path folder(arguments[1]);
  std::filesystem::create_directories(folder);

  // 16-bit and 32-bit indices, shared meshes, open and see-through ones, nothing at all.
  Scene large;
  large.solids = {named::ball("large", 0.1f, 140, Color(0.5f))};
  large.instances = {{0, {}, "large"}};
  write_whole(folder / "mixed.glb", write_glb(named::mixed(), {.provenance = "a \"quoted\" \\ text, ü"}));
  write_whole(folder / "axes.glb", write_glb(named::axes_of_balls()));
  write_whole(folder / "materials.glb", write_glb(named::with_materials()));
  write_whole(folder / "large.glb", write_glb(large));
  write_whole(folder / "textured.glb", write_glb(large, std::vector{baked(large.solids[0], style_named("ink"))}));
  const Scene shining = named::with_materials();
  std::vector<BakedSolid> with_maps;
  for (const Solid& solid : shining.solids)
    with_maps.push_back(baked(solid, style_named("ink"), {.texels = 128, .maps = Maps::all}));
  write_whole(folder / "maps.glb", write_glb(shining, with_maps));
  const std::vector<std::vector<Solid>> levels{{named::ball("large_LOD1", 0.1f, 70, Color(0.5f))}};
  write_whole(folder / "levels.glb", write_glb(large, {}, levels));
  write_whole(folder / "empty.glb", write_glb(Scene{}));

  // One the validator must refuse.
  std::filesystem::create_directories(folder / "broken");
  const std::string whole = write_glb(named::mixed());
  write_whole(folder / "broken" / "truncated.glb", whole.substr(0, whole.size() - 100));
  return 0;
}
