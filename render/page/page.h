// A fruit as a page of its own: one HTML file that opens from disk, and cuts it live (docs/reference/page.md).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "render/page/asset.h"
#include "render/page/page_options.h"

namespace pomona {

/// Fruits that a page shows side by side.
constexpr std::size_t max_page_family = 8;

/// Needs nothing besides itself, but a browser with WebGL 2. The same asset gives the same bytes.
std::string write_page(const Asset& asset, const PageOptions& options);

/// Several side by side, cut by the same knives: seeds of one template. The page is called by the first.
/// \throws Error (usage) for none, or more than max_page_family.
std::string write_page(std::span<const Asset> family, const PageOptions& options);

/// What Picture of picture.js takes: style, opening cuts and shaders, as JSON that is safe within a script element.
std::string page_options(const PageOptions& options);

}  // namespace pomona
