// Colours from the picture under a sketch, written into the template.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

struct SampledTemplate {
  std::string toml;  ///< the template's text, with new stops; all else as it was
  int ramps = 0;     ///< number of colours that were taken
};

/// Takes every color = { sample = "#line" } of a template: at `stops` places along the line, from the bottom up, the
/// median of the picture's pixels around, one by one for red, green and blue. Replaces `along`, or adds it.
/// \throws Error (bad_data) with all that is wrong, also if the template as it then stands has other mistakes.
SampledTemplate sample_colors(const std::filesystem::path& file);

}  // namespace pomona
