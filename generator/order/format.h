// The formats of files, known by their endings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// Formats, in the order in which messages list them.
enum class Format { ply, glb, usda, obj, stl, pov, png, svg, json, html, pomona, xml, urdf };

/// The endings without their dots, in the order of Format.
const std::vector<std::string>& format_names();

/// "glb".
const std::string& name_of(Format format);

/// The format of an ending without its dot, in lower case or capitals; nothing if there is none.
std::optional<Format> format_called(std::string_view ending);

/// ".glb .usda", in the order of Format, whatever the order of `formats`.
std::string endings_of(const std::vector<Format>& formats);

/// A file that is wanted.
struct Output {
  std::filesystem::path file;  ///< "-" is standard output
  Format format = Format::glb;
};

/// Whether any of the outputs is of one of these formats.
bool any_is(const std::vector<Output>& outputs, const std::vector<Format>& formats);

/// Whether all of them are.
bool all_are(const std::vector<Output>& outputs, const std::vector<Format>& formats);

/// Fruit that is cut after it has left the program: pages and assets.
inline const std::vector<Format> live_formats = {Format::html, Format::pomona};

/// Models of simulators: pieces lie on the ground, as in pictures.
inline const std::vector<Format> model_formats = {Format::xml, Format::urdf};

/// Flat pictures.
inline const std::vector<Format> picture_formats = {Format::png, Format::svg};

}  // namespace pomona
