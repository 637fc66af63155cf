// Pictures that a sketch is drawn over: in files beside it, or within it.
#pragma once

#include <filesystem>
#include <string>

#include <glm/vec2.hpp>

#include "render/image/png.h"

namespace pomona {

struct LinkedPicture {
  std::string href;    ///< the path from the folder, as a URI
  glm::dvec2 size{0};  ///< pixels
};

/// All bytes of a picture's file.
/// \param place where it is named, for messages.
/// \throws Error (input_missing), (bad_data) beyond 256 MiB.
std::string picture_bytes(const std::filesystem::path& file, const std::string& place);

/// How an SVG names a picture with these bytes that is to lie at `step`, from the SVG's folder.
/// \param file its name, for messages.
/// \throws Error (bad_data) if it is no PNG.
LinkedPicture linked_picture(const std::filesystem::path& step, const std::string& bytes, const std::string& file);

/// The picture that an SVG in `folder` names: a relative path to a PNG in that folder or below, or a data URI.
/// \param place where it is named, for messages.
/// \throws Error (bad_data) for other kinds of links and pictures, and beyond 100 million pixels, (input_missing).
TransparentImage read_linked_picture(const std::string& href, const std::filesystem::path& folder,
                                     const std::string& place);

/// Reads a PNG. Its size is checked before memory is allocated.
/// \throws Error (bad_data) for what is no PNG, is spoilt, or has more than 100 million pixels; (input_missing).
TransparentImage read_picture(const std::filesystem::path& file);

}  // namespace pomona
