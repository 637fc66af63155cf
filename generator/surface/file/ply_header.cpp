#include "generator/surface/file/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "generator/surface/file/byte_mark.h"

namespace pomona {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> type_names{{{"char", PlyType::int8},
                                               {"int8", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"uint8", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"int16", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"uint16", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"int32", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"uint32", PlyType::uint32},
                                               {"float", PlyType::float32},
                                               {"float32", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"float64", PlyType::float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  PlyHeader parse() {
    // The first line identifies a PLY file and shows how its lines end.
    if (const std::optional<ByteMark> mark = byte_mark_of(bytes_)) {
      if (!mark->is_utf8) fail("this is UTF-16 or UTF-32 text", "save it as ASCII");
      line_end_ = mark->size;
    }
    const std::size_t first_end = bytes_.find_first_of("\r\n", line_end_);
    if (first_end != std::string_view::npos && bytes_.substr(first_end, 2) != "\r\n") break_ = bytes_[first_end];
    next_line();
    if (word() != "ply") fail("this is no PLY file", "its first line must be \"ply\"");

    // Each line begins with its keyword, up to the one that ends the header.
    bool has_format = false;
    while (true) {
      next_line();
      const std::string_view keyword = word();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        if (has_format) fail("the format stands twice");
        read_format();
        has_format = true;
      } else if (keyword == "comment" || keyword == "obj_info") {
        header_.comments.emplace_back(rest());
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        fail("\"" + printable(keyword) + "\" has no meaning in a PLY header");
      }
    }

    // Without a format the values after the header cannot be read.
    if (!has_format) fail("the header has no format line");
    header_.size = line_end_;
    return std::move(header_);
  }

 private:
  void next_line() {
    // More than any real header; the bytes after it may be anything.
    constexpr std::size_t longest_header = std::size_t{1} << 20;
    at_ = word_at_ = line_end_;
    const std::size_t end = bytes_.substr(0, longest_header).find(break_, at_);
    if (end == std::string_view::npos) fail("the header does not end", "it must end with the line \"end_header\"");
    line_end_ = end + 1;
    line_ = bytes_.substr(0, end);
    if (line_.size() > at_ && line_.ends_with('\r')) line_.remove_suffix(1);
  }

  /// The next word of the line; empty at its end.
  std::string_view word() {
    while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) ++at_;
    word_at_ = at_;
    while (at_ < line_.size() && line_[at_] != ' ' && line_[at_] != '\t') ++at_;
    return line_.substr(word_at_, at_ - word_at_);
  }

  std::string_view rest() {
    while (at_ < line_.size() && line_[at_] == ' ') ++at_;
    return line_.substr(std::min(at_, line_.size()));
  }

  void read_format() {
    const std::string_view format = word();
    if (format == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (format == "binary_little_endian") {
      header_.format = PlyFormat::binary_little_endian;
    } else if (format == "binary_big_endian") {
      header_.format = PlyFormat::binary_big_endian;
    } else {
      fail("format \"" + printable(format) + "\" is not known", "use ascii, binary_little_endian or binary_big_endian");
    }
    if (word() != "1.0") fail("only version 1.0 of PLY is known");
  }

  void read_element() {
    PlyElement element;
    element.byte = word_at_;
    element.name = word();
    if (element.name.empty()) fail("the element has no name");
    for (const PlyElement& known : header_.elements) {
      if (known.name == element.name) fail("element \"" + printable(element.name) + "\" is declared twice");
    }
    const std::string_view count = word();
    const auto [end, status] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (status != std::errc() || end != count.data() + count.size()) {
      fail("\"" + printable(count) + "\" is not a number of elements");
    }
    check_number(header_.elements.size());
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty property;
    std::string_view type = word();
    if (type == "list") {
      property.count_type = type_of(word());
      if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64) {
        fail("a list's length must have an integer type");
      }
      type = word();
    }
    property.type = type_of(type);
    property.name = word();
    if (property.name.empty()) fail("the property has no name");
    std::vector<PlyProperty>& known = header_.elements.back().properties;
    for (const PlyProperty& other : known) {
      if (other.name == property.name) fail("property \"" + printable(property.name) + "\" is declared twice");
    }
    check_number(known.size());
    known.push_back(std::move(property));
  }

  PlyType type_of(std::string_view name) const {
    const auto found =
        std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& t) { return t.name == name; });
    if (found == type_names.end())
      fail("\"" + printable(name) + "\" is not a type", "types are char, uchar, ..., float, double");
    return found->type;
  }

  void check_number(std::size_t number) const {
    if (number >= 256) fail("more than 256 elements or properties");
  }

  static std::string printable(std::string_view text) {
    std::string clean(text.substr(0, 40));
    for (char& c : clean) {
      if (c < ' ' || c > '~') c = '?';
    }
    return clean;
  }

  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    throw Error(ExitStatus::bad_data, {{place_in_text(bytes_, word_at_, file_), message, hint}});
  }

  std::string_view bytes_;
  std::string file_;
  PlyHeader header_;
  std::string_view line_;     ///< from the start of the file to the end of the line
  std::size_t line_end_ = 0;  ///< past the line's end
  char break_ = '\n';         ///< ends a line, perhaps after a CR; old programs end lines with CR alone
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;
};

}  // namespace

SourcePlace place_in_text(std::string_view bytes, std::size_t byte, const std::string& file) {
  const std::string_view before = bytes.substr(0, byte);
  const bool ends_with_cr = bytes.find('\n') == std::string_view::npos;
  const char line_break = ends_with_cr ? '\r' : '\n';
  SourcePlace place;
  place.file = file;
  place.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), line_break));
  const std::size_t line_start = before.rfind(line_break);
  place.column = static_cast<int>(before.size() - (line_start == std::string_view::npos ? 0 : line_start + 1)) + 1;
  return place;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& file) {
  return HeaderParser(bytes, file).parse();
}

}  // namespace pomona
