#include "generator/surface/file/obj_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>

#include "generator/base/error.h"
#include "generator/mesh/polygon_triangles.h"
#include "generator/surface/file/byte_mark.h"
#include "generator/surface/file/channel_scale.h"

namespace pomona {

namespace {

constexpr double farthest = 1e9;            // in units of the file
constexpr std::size_t max_vertices = 5e6;   // of the whole file
constexpr std::size_t max_corners = 65536;  // of one face

// How a name in the file can match the wanted object; the first kind that occurs counts.
enum Meaning : std::uint8_t { object_of_the_name = 1, group_of_the_name = 2, group_with_the_word = 4 };

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file, const std::string& object)
      : text_(text), file_(file), object_(object) {}

  PlainMesh parse() {
    if (const std::optional<ByteMark> mark = byte_mark_of(text_)) {
      if (!mark->is_utf8) fail_whole("is UTF-16 or UTF-32 text", "save it as UTF-8 or ASCII");
      text_.remove_prefix(mark->size);
    }
    while (next_line()) read_line();
    if (furthest_.size() > 0) check_corners_to_come();
    if (!object_.empty() && meanings_ == 0)
      fail_whole("has no object \"" + object_ + "\"", "it has: " + listed_names(names_));
    append_faces();
    if (mesh_.triangle.empty()) fail_whole("holds no faces", "export the mesh as polygons");
    color_vertices();
    PlainMesh used = without_unused(mesh_);
    if (faces_left_out_ > 0) used.notes.push_back(few_corners_note(faces_left_out_));
    return used;
  }

 private:
  // ---- Lines and words ----

  bool is_break(std::size_t at) const { return at < text_.size() && (text_[at] == '\n' || text_[at] == '\r'); }

  /// The end of the line that starts here; behind_break() is the start of the next one, after LF, CR or both.
  std::size_t end_of_line(std::size_t at) const { return std::min(text_.find_first_of("\r\n", at), text_.size()); }
  std::size_t behind_break(std::size_t at) const {
    if (at >= text_.size()) return text_.size();
    return at + (text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1);
  }

  bool next_line() {
    line_number_ += lines_of_line_;
    if (next_ >= text_.size()) return false;
    std::size_t start = next_, end = end_of_line(start);
    line_start_ = start;
    lines_of_line_ = 1;
    while (goes_on(line_start_, start, end)) {
      start = behind_break(end);
      end = end_of_line(start);
      ++lines_of_line_;
    }
    line_end_ = end;
    next_ = behind_break(end);
    at_ = word_at_ = line_start_;
    return true;
  }

  /// A backslash at the end joins a line to the next, except in comments; in names only after a blank, because file
  /// names may end with a backslash.
  bool goes_on(std::size_t first, std::size_t start, std::size_t end) const {
    const std::string_view line = text_.substr(start, end - start);
    const std::size_t last = line.find_last_not_of(" \t\v\f");
    if (end >= text_.size() || last == std::string_view::npos || line[last] != '\\') return false;
    for (std::size_t k = 0; k < line.size(); ++k)
      if (line[k] == '#' && is_comment(start + k)) return false;
    const std::size_t keyword = std::min(text_.find_first_not_of(" \t", first), end);
    const bool has_numbers =
        is_one_of(text_.substr(keyword, std::min(text_.find_first_of(" \t", keyword), end) - keyword),
                  std::array<std::string_view, 10>{"v", "vt", "vn", "vp", "f", "fo", "l", "p", "curv", "parm"});
    return has_numbers || last == 0 || line[last - 1] == ' ' || line[last - 1] == '\t';
  }

  /// False inside "1.#INF", with which some programs write values that are not numbers.
  bool is_comment(std::size_t at) const {
    const std::string_view after = text_.substr(at + 1, 4);
    return !after.starts_with("INF") && !after.starts_with("IND") && after != "QNAN" && after != "SNAN";
  }

  bool is_blank(std::size_t at) const {
    const char c = text_[at];
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f') return true;
    if (c != '\\') return false;
    const std::size_t behind = text_.find_first_not_of(" \t\v\f", at + 1);
    return behind < line_end_ && is_break(behind);
  }

  /// The next word of the line, up to a comment.
  std::string_view word() {
    while (at_ < line_end_ && is_blank(at_)) ++at_;
    word_at_ = at_;
    while (at_ < line_end_ && !is_blank(at_)) {
      if (text_[at_] == '#' && is_comment(at_)) {
        const std::string_view before = text_.substr(word_at_, at_ - word_at_);
        at_ = line_end_;
        return before;
      }
      ++at_;
    }
    return text_.substr(word_at_, at_ - word_at_);
  }

  void read_line() {
    const std::string_view keyword = word();
    if (keyword.empty()) return;
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    } else if (keyword == "o" || keyword == "g") {
      read_name(keyword == "o");
    } else {
      pass_over(keyword);
    }
  }

  /// Notes elements with a shape that is not read. Other keywords, known or not, have no shape.
  void pass_over(std::string_view keyword) {
    static constexpr std::array<std::string_view, 7> curved{"curv", "surf", "bsp", "bzp", "cdc", "cdp", "res"};
    if (is_one_of(keyword, curved))
      fail("\"" + std::string(keyword) + "\" makes a curved surface, and only polygons are read",
           "export the mesh as polygons");
    if (keyword == "call") fail("\"call\" leads to another file, and only this one is read", "put the lines in here");
    if (keyword == "V" || keyword == "F") fail("keywords have small letters: v and f");
    if (std::isalpha(static_cast<unsigned char>(keyword.front())) == 0 && keyword.front() != '!' &&
        keyword.front() != '/')
      fail("a line of an .obj begins with a keyword", "a number may have slipped to a line of its own");
  }

  // ---- Names ----

  /// Reads the rest of the line as a name. Groups may have several names; an object ends the groups before it.
  void read_name(bool is_object) {
    const std::size_t start = std::min(text_.find_first_not_of(" \t", at_), line_end_);
    const auto words_of = [&] {
      std::vector<std::string> words;
      at_ = start;
      for (std::string_view more = word(); !more.empty(); more = word()) words.emplace_back(more);
      return words;
    };
    const std::vector<std::string> words = words_of();  // without a comment
    std::string name;
    for (const std::string& one : words) name += (name.empty() ? "" : " ") + one;
    std::string_view whole = text_.substr(start, line_end_ - start);
    while (!whole.empty() && (whole.back() == ' ' || whole.back() == '\t')) whole.remove_suffix(1);

    const bool same = !object_.empty() && (name == object_ || whole == object_);
    const bool among = !object_.empty() && std::find(words.begin(), words.end(), object_) != words.end();
    if (is_object) {
      here_ = same ? object_of_the_name : 0;
    } else {
      here_ = static_cast<std::uint8_t>((here_ & object_of_the_name) | (same ? group_of_the_name : 0) |
                                        (among ? group_with_the_word : 0));
    }
    meanings_ = static_cast<std::uint8_t>(meanings_ | here_);
    constexpr std::size_t max_names = 64;
    if (names_.size() < max_names && std::find(names_.begin(), names_.end(), name) == names_.end())
      names_.push_back(name);
  }

  // ---- Vertices ----

  double number(std::string_view text) const {
    if (text.empty()) fail("a vertex needs three numbers");
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size()) fail("this is not a number");
    if (!std::isfinite(value)) fail("this number is not finite");
    if (std::fabs(value) > farthest) fail("this number is too large");
    return value;
  }

  void read_vertex() {
    if (mesh_.position.size() == max_vertices) fail("more than 5 000 000 vertices", "simplify the mesh");
    glm::dvec3 position;
    for (int k = 0; k < 3; ++k) position[k] = number(word());
    mesh_.position.push_back(position);

    // x y z r g b; a single fourth number is a weight.
    std::array<double, 4> more{};
    int count = 0;
    std::string_view text = word();
    for (; !text.empty() && count < 4; text = word()) more[static_cast<std::size_t>(count++)] = number(text);
    if (count == 2 || !text.empty())
      fail("a vertex has 3 numbers, 4 with a weight, or 6 with a colour", "export it without other values");
    if (count < 3) return;
    channel_.resize(mesh_.position.size(), glm::dvec3(no_color));
    channel_.back() = {more[0], more[1], more[2]};
  }

  void color_vertices() {
    if (channel_.empty()) return;
    double largest = 0;
    for (const glm::dvec3& c : channel_) largest = std::max({largest, c.r, c.g, c.b});
    const double white = white_of_floats(largest);
    channel_.resize(mesh_.position.size(), glm::dvec3(no_color));
    for (const glm::dvec3& c : channel_) {
      Color color(0.5f);
      for (int k = 0; k < 3 && c.r != no_color; ++k)
        color[k] = static_cast<float>(linear_from_srgb(std::clamp(c[k] / white, 0.0, 1.0)));
      mesh_.color.push_back(color);
    }
  }

  // ---- Faces ----

  /// "7", "7/1", "7//3" or "-2": vertices count from 1, or backwards from the newest; a face may come before its
  /// vertices.
  std::uint32_t corner(std::string_view text) {
    const std::string_view index = text.substr(0, text.find('/'));
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(index.data(), index.data() + index.size(), value);
    if (status != std::errc() || end != index.data() + index.size()) fail("this is not the number of a vertex");
    const auto count = static_cast<std::int64_t>(mesh_.position.size());
    if (value == 0 || value > static_cast<std::int64_t>(max_vertices) || value < -count) fail_no_vertex(place());
    if (value > count && (furthest_.empty() || value > furthest_.back().vertex))
      furthest_.push_back({value, line_start_, word_at_, line_number_});
    return static_cast<std::uint32_t>(value > 0 ? value - 1 : count + value);
  }

  void read_face() {
    const std::size_t first = corners_.size();
    for (std::string_view text = word(); !text.empty(); text = word()) {
      if (corners_.size() - first == max_corners) fail("a face with more than 65536 corners");
      const std::uint32_t next = corner(text);
      if (corners_.size() == first || corners_.back() != next) corners_.push_back(next);
    }
    while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
    const std::size_t count = corners_.size() - first;
    if (count < 3) {
      corners_.resize(first);
      ++faces_left_out_;
      return;
    }
    triangles_ += count - 2;
    if (!object_.empty() && here_ == 0) {
      corners_.resize(first);
      triangles_ -= count - 2;
    } else {
      faces_.push_back({first, static_cast<std::uint32_t>(count), here_, line_number_});
    }
    if (triangles_ > max_mesh_triangles) fail("more than 2 000 000 triangles", "simplify the mesh");
  }

  /// Refuses the first face that names a missing vertex.
  void check_corners_to_come() const {
    for (const Awaited& awaited : furthest_) {
      if (awaited.vertex > static_cast<std::int64_t>(mesh_.position.size()))
        fail_no_vertex(place_of(awaited.line_start, awaited.word_at, awaited.line));
    }
  }

  void append_faces() {
    // Objects first; groups only if no object has the name.
    const auto wanted = static_cast<std::uint8_t>(meanings_ & (~meanings_ + 1));
    std::vector<glm::dvec3> places;
    for (const Face& face : faces_) {
      if (!object_.empty() && (face.meanings & wanted) == 0) continue;
      const std::span<const std::uint32_t> corners(&corners_[face.first], face.count);
      places.clear();
      for (const std::uint32_t c : corners) places.push_back(mesh_.position[c]);
      const auto triangles = polygon_triangles(places);
      if (!triangles) {
        throw Error(ExitStatus::bad_data, {{{file_, face.line, 1, {}},
                                            "this face crosses or touches itself",
                                            "triangulate the mesh before it is exported"}});
      }
      for (const glm::uvec3& t : *triangles) mesh_.triangle.emplace_back(corners[t.x], corners[t.y], corners[t.z]);
    }
  }

  // ---- Mistakes ----

  /// The place of a word in a line that may be joined from several.
  SourcePlace place_of(std::size_t line_start, std::size_t word_at, int line) const {
    for (std::size_t end = end_of_line(line_start); end < word_at; end = end_of_line(line_start)) {
      line_start = behind_break(end);
      ++line;
    }
    return {file_, line, static_cast<int>(word_at - line_start) + 1, {}};
  }
  SourcePlace place() const { return place_of(line_start_, word_at_, line_number_); }

  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    throw Error(ExitStatus::bad_data, {{place(), message, hint}});
  }

  [[noreturn]] static void fail_no_vertex(const SourcePlace& place) {
    throw Error(ExitStatus::bad_data, {{place, "there is no such vertex", "vertices are numbered from 1"}});
  }

  [[noreturn]] void fail_whole(const std::string& message, const std::string& hint) const {
    throw Error(ExitStatus::bad_data, {{{file_, std::max(1, line_number_ - 1), 1, {}}, message, hint}});
  }

  struct Face {
    std::size_t first = 0;  ///< in corners_
    std::uint32_t count = 0;
    std::uint8_t meanings = 0;
    int line = 0;
  };
  /// The highest vertex number so far that was still to come, and the word that named it.
  struct Awaited {
    std::int64_t vertex = 0;
    std::size_t line_start = 0, word_at = 0;
    int line = 0;
  };
  static constexpr double no_color = -2 * farthest;

  std::string_view text_;
  std::string file_, object_;
  std::size_t line_start_ = 0, line_end_ = 0, next_ = 0;  ///< of the current line, and the start of the next
  std::size_t at_ = 0, word_at_ = 0;
  int line_number_ = 1, lines_of_line_ = 0;
  std::uint8_t here_ = 0, meanings_ = 0;  ///< meanings of the current names, and of all names so far
  std::vector<std::string> names_;
  std::vector<glm::dvec3> channel_;  ///< sRGB as in the file; empty without colours
  std::vector<std::uint32_t> corners_;
  std::vector<Face> faces_;
  std::vector<Awaited> furthest_;
  std::size_t triangles_ = 0;
  std::size_t faces_left_out_ = 0;  ///< of less than three corners
  PlainMesh mesh_;
};

}  // namespace

PlainMesh parse_obj(std::string_view text, const std::string& file, const std::string& object) {
  return ObjParser(text, file, object).parse();
}

}  // namespace pomona
