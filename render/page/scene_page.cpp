#include <utility>

#include "generator/base/error.h"
#include "render/page/asset_file.h"
#include "render/page/page_scene.h"
#include "render/page/page_text.h"

namespace pomona {

std::string write_scene_page(const PageScene& scene, const PageOptions& options) {
  check_fits_a_page(scene.scene, scene.fruits.size());
  PageText page{.title = scene.title, .latin = {}, .about = {}, .packed = {}, .script = "scene_script.js"};
  page.about =
      scene.title + ": " + std::to_string(scene.scene.instances.size()) +
      " pieces, to be turned and pulled apart. N and P pick the next and the previous piece, Enter takes it out "
      "to be cut, Escape puts it back.";
  page.packed.push_back({"scene", "scene", packed_scene(scene)});
  for (const Asset& asset : scene.fruits)
    page.packed.push_back(
        {"asset", "asset-" + std::to_string(page.packed.size() - 1), write_asset(asset, options.made_by)});
  std::string text = page_text(page, options);
  if (text.size() > max_scene_page_bytes) {
    throw Error(ExitStatus::usage,
                "the page would have " + std::to_string(text.size() / 1'000'000) +
                    " MB; a page of a scene has at most " + std::to_string(max_scene_page_bytes / 1'000'000),
                "fewer variants, each placed more often, or --detail 0.5");
  }
  return text;
}

}  // namespace pomona
