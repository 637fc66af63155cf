#include "generator/text/toml_limits.h"

#include <vector>

#include "generator/base/utf8.h"

namespace pomona {

namespace {

/// Goes through the text once, skips comments and strings, and counts what is limited.
class Scanner {
 public:
  Scanner(std::string_view text, const TomlLimits& limits) : text_(text), limits_(limits) {}

  std::optional<TomlExcess> run() {
    while (at_ < text_.size() && !excess_) {
      const char c = text_[at_];
      if (c == '#') {
        while (at_ < text_.size() && text_[at_] != '\n' && !excess_) step();
      } else if (c == '"' || c == '\'') {
        skip_string(c);
      } else {
        count(c);
        step();
      }
    }
    return excess_;
  }

 private:
  /// Advances by one character, with line and column, which count characters, not bytes.
  void step() {
    const std::size_t bytes = utf8_length(text_.substr(at_));
    if (bytes == 0) return refuse("this byte is not UTF-8; save the file as UTF-8");
    if (text_[at_] == '\n') {
      ++place_.line;
      place_.column = 0;
    }
    ++place_.column;
    at_ += bytes;
  }

  void count(char c) {
    switch (c) {
      // Brackets nest, and each counts its own commas.
      case '[':
      case '{':
        commas_.push_back(0);
        key_dots_ = 0;
        if (commas_.size() > static_cast<std::size_t>(limits_.depth))
          refuse_number("brackets nest deeper than ", limits_.depth);
        break;
      case ']':
      case '}':
        if (!commas_.empty()) commas_.pop_back();
        break;
      // Commas, equals signs and ends of lines each count as a value.
      case ',':
        key_dots_ = 0;
        count_value();
        if (!commas_.empty() && ++commas_.back() >= limits_.array_values) {
          refuse_number("an array holds more values than ", static_cast<long>(limits_.array_values));
        }
        break;
      // Each dot of a key opens a table within a table.
      case '.':
        if (++key_dots_ >= limits_.depth) refuse_number("a dotted key nests deeper than ", limits_.depth);
        break;
      case '=':
        key_dots_ = 0;
        count_value();
        break;
      case '\n':
        key_dots_ = 0;
        count_value();
        break;
      default:
        break;
    }
  }

  void count_value() {
    if (++values_ > limits_.values)
      refuse_number("the file holds more values than ", static_cast<long>(limits_.values));
  }

  bool here(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  /// Skips a string of any of TOML's four kinds; a broken one ends with its line or the text.
  void skip_string(char quote) {
    const std::string triple(3, quote);
    const bool many_lines = here(triple);
    const TomlPlace start = place_;
    const std::size_t first = at_;
    for (int i = many_lines ? 3 : 1; i > 0; --i) step();
    while (at_ < text_.size() && !excess_) {
      if (many_lines ? here(triple) : text_[at_] == quote) break;
      if (!many_lines && text_[at_] == '\n') return;
      if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) step();
      if (!excess_) step();
    }
    if (excess_) return;
    if (at_ - first > limits_.string_bytes + (many_lines ? 3 : 1)) {
      place_ = start;
      return refuse_number("a text is longer than this many bytes: ", static_cast<long>(limits_.string_bytes));
    }
    // Up to two quotes may stand directly before the closing three.
    for (int i = many_lines ? 5 : 1; i > 0 && at_ < text_.size() && text_[at_] == quote; --i) step();
  }

  void refuse(const std::string& message) {
    if (!excess_) excess_ = TomlExcess{place_, message};
  }
  void refuse_number(const std::string& message, long number) { refuse(message + std::to_string(number)); }

  std::string_view text_;
  const TomlLimits& limits_;
  std::size_t at_ = 0;
  TomlPlace place_{1, 1};
  std::vector<std::size_t> commas_;  ///< number of commas in each open bracket
  int key_dots_ = 0;
  std::size_t values_ = 0;
  std::optional<TomlExcess> excess_;
};

}  // namespace

std::optional<TomlExcess> find_excess(std::string_view text, const TomlLimits& limits) {
  if (text.size() > limits.bytes) {
    return TomlExcess{{1, 1}, "the file is larger than " + std::to_string(limits.bytes >> 20) + " MiB"};
  }
  return Scanner(text, limits).run();
}

}  // namespace pomona
