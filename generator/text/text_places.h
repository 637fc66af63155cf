// Lines and columns of places in a text, for messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

/// Goes through a text once, so places must be asked for in ascending order.
class TextPlaces {
 public:
  TextPlaces(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// Line and column, from 1, of a byte, or of the end of the text if the byte lies beyond it.
  SourcePlace at(std::size_t offset) {
    for (; offset_ < std::min(offset, text_.size()); ++offset_) {
      column_ = text_[offset_] == '\n' ? 1 : column_ + 1;
      if (text_[offset_] == '\n') ++line_;
    }
    return {file_, line_, column_, {}};
  }

 private:
  std::string_view text_;
  std::string file_;
  std::size_t offset_ = 0;
  int line_ = 1, column_ = 1;
};

}  // namespace pomona
