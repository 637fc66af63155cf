// A fruit as a page of its own: one HTML file that opens from disk, and cuts it live (docs/page.md).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "generator/knife/knife.h"
#include "render/page/asset.h"
#include "render/style/style.h"

namespace pomona {

/// Cuts that a page makes at a time.
constexpr std::size_t most_page_cuts = 4;

/// Fruits that a page shows side by side.
constexpr std::size_t most_page_family = 8;

/// A plane that a page opens with. Those of one knife follow one another; `step` is by how much the number of the
/// knife's cell grows beyond the plane, and 0 of wedges, whose cells are counted by their angle
/// (generator/knife/knife_planes.h): of cells that hold as much of a spared part, the first in this order has it.
struct PageCut {
  CuttingPlane plane;
  int knife = 0, step = 1;
};

struct PageOptions {
  Style style;
  std::vector<PageCut> cuts;  ///< it opens with these; at most most_page_cuts
  std::string made_by;        ///< "pomona 0.3.0, seed 2"
};

/// Needs nothing besides itself, but a browser with WebGL 2. The same asset gives the same bytes.
std::string write_page(const Asset& asset, const PageOptions& options);

/// Several side by side, cut by the same knives: seeds of one template. The page is called by the first.
/// \throws Error (usage) for none, or more than most_page_family.
std::string write_page(std::span<const Asset> family, const PageOptions& options);

/// What Picture of picture.js takes: style, opening cuts and shaders, as JSON that is safe within a script element.
std::string page_options(const PageOptions& options);

}  // namespace pomona
