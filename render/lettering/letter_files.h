// The files render/lettering/*.letters, which become part of the program.
#pragma once

#include <span>
#include <string_view>

namespace pomona {

struct LetterFile {
  std::string_view name;  ///< of the file, without folder and ending
  std::string_view text;
};

std::span<const LetterFile> letter_files();

}  // namespace pomona
