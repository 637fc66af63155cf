// A fruit as a page: one HTML file that opens from disk, and cuts it live (docs/reference/page.md).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "render/page/asset.h"
#include "render/page/page_options.h"

namespace pomona {

/// Limit of fruits that a page shows side by side.
constexpr std::size_t max_page_family = 8;

/// It needs nothing but a browser with WebGL 2. The same asset gives the same bytes.
std::string write_page(const Asset& asset, const PageOptions& options);

/// Several seeds of one template side by side, cut by the same knives. The page has the name of the first.
/// \throws Error (usage) for none, or more than max_page_family.
std::string write_page(std::span<const Asset> family, const PageOptions& options);

/// The options of Picture in picture.js: style, opening cuts and shaders, as JSON that is safe within a script element.
std::string page_options(const PageOptions& options);

}  // namespace pomona
