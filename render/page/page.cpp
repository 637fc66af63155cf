#include "render/page/page.h"

#include <utility>

#include "generator/base/error.h"
#include "render/page/asset_file.h"
#include "render/page/page_text.h"

namespace pomona {

std::string write_page(const Asset& asset, const PageOptions& options) {
  return write_page(std::span(&asset, 1), options);
}

std::string write_page(std::span<const Asset> family, const PageOptions& options) {
  if (family.empty() || family.size() > max_page_family) {
    throw Error(ExitStatus::usage, "a page shows up to " + std::to_string(max_page_family) + " fruits side by side",
                "take fewer");
  }
  const Asset& first = family.front();
  PageText page{.title = first.title, .latin = first.latin};
  const std::string what = first.title + ", " + first.latin;
  page.about = family.size() == 1
                   ? what + ", to be turned and cut."
                   : std::to_string(family.size()) + " fruits side by side, each of another seed: " + what +
                         ", to be turned, and cut all at once.";
  for (const Asset& asset : family) {
    page.packed.push_back({.kind = "asset",
                           .id = "asset-" + std::to_string(page.packed.size()),
                           .bytes = write_asset(asset, options.made_by)});
  }
  return page_text(page, options);
}

}  // namespace pomona
