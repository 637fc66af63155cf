#include "generator/surface/file/obj_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr double farthest = 1e9;             // in units of the file
constexpr std::size_t most_vertices = 5e6;   // of the whole file
constexpr std::size_t most_corners = 65536;  // of one face

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file, const std::string& object)
      : text_(text), file_(file), object_(object) {}

  PlainMesh parse() {
    while (next_line()) read_line();
    if (!object_.empty() && !found_) fail_whole("has no object \"" + object_ + "\"", "it has: " + listed_names(names_));
    if (mesh_.triangle.empty()) fail_whole("holds no faces", "export the mesh as polygons");
    if (!colored_) mesh_.color.clear();
    return without_unused(mesh_);
  }

 private:
  bool next_line() {
    if (end_ >= text_.size() && line_number_ > 0) return false;
    const std::size_t start = line_number_ == 0 ? 0 : end_;
    if (start >= text_.size()) return false;
    const std::size_t newline = text_.find('\n', start);
    end_ = newline == std::string_view::npos ? text_.size() : newline + 1;
    line_ = text_.substr(start, (newline == std::string_view::npos ? text_.size() : newline) - start);
    ++line_number_;
    at_ = word_at_ = 0;
    return true;
  }

  std::string_view word() {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (at_ < line_.size() && is_space(line_[at_])) ++at_;
    word_at_ = at_;
    while (at_ < line_.size() && !is_space(line_[at_])) ++at_;
    return line_.substr(word_at_, at_ - word_at_);
  }

  void read_line() {
    const std::string_view keyword = word();
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f") {
      read_face();
    } else if (keyword == "o" || keyword == "g") {
      read_name(keyword == "o");
    }
  }

  /// The rest of the line. Groups may have several names; an object ends the groups before it.
  void read_name(bool is_object) {
    std::string name(word());
    for (std::string_view more = word(); !more.empty(); more = word()) name += " " + std::string(more);
    (is_object ? in_object_ : in_group_) = !name.empty() && name == object_;
    if (is_object) in_group_ = false;
    found_ = found_ || in_object_ || in_group_;
    constexpr std::size_t most_names = 64;
    if (names_.size() < most_names && std::find(names_.begin(), names_.end(), name) == names_.end()) {
      names_.push_back(name);
    }
  }

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
    if (mesh_.position.size() == most_vertices) fail("more than 5 000 000 vertices", "simplify the mesh");
    glm::dvec3 position;
    for (int k = 0; k < 3; ++k) position[k] = number(word());
    mesh_.position.push_back(position);

    // x y z r g b; a fourth number alone is a weight.
    std::array<double, 4> more{};
    int count = 0;
    for (std::string_view text = word(); !text.empty() && count < 4; text = word()) {
      more[static_cast<std::size_t>(count++)] = number(text);
    }
    Color color(0.5f);
    for (int k = 0; k < 3 && count >= 3; ++k) {
      const double channel = std::clamp(more[static_cast<std::size_t>(k)], 0.0, 1.0);
      color[k] = static_cast<float>(linear_from_srgb(channel));
    }
    colored_ = colored_ || count >= 3;
    mesh_.color.push_back(color);
  }

  /// "7", "7/1", "7//3" or "-2": vertices count from 1, or backwards from the newest.
  std::uint32_t corner(std::string_view text) const {
    const std::string_view index = text.substr(0, text.find('/'));
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(index.data(), index.data() + index.size(), value);
    if (status != std::errc() || end != index.data() + index.size()) fail("this is not the number of a vertex");
    const auto count = static_cast<std::int64_t>(mesh_.position.size());
    if (value == 0 || value > count || value < -count) {
      fail("there is no such vertex", "vertices are numbered from 1, in the order of the file");
    }
    return static_cast<std::uint32_t>(value > 0 ? value - 1 : count + value);
  }

  void read_face() {
    if (!object_.empty() && !in_object_ && !in_group_) return;
    std::vector<std::uint32_t> corners;
    for (std::string_view text = word(); !text.empty(); text = word()) {
      if (corners.size() == most_corners) fail("a face with more than 65536 corners");
      corners.push_back(corner(text));
    }
    if (corners.size() < 3) fail("a face needs at least 3 vertices");
    if (mesh_.triangle.size() + corners.size() - 2 > most_mesh_triangles) {
      fail("more than 2 000 000 triangles", "simplify the mesh");
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      mesh_.triangle.emplace_back(corners[0], corners[k - 1], corners[k]);
    }
  }

  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    throw Error(ExitStatus::bad_data, {{{file_, line_number_, static_cast<int>(word_at_) + 1, {}}, message, hint}});
  }

  [[noreturn]] void fail_whole(const std::string& message, const std::string& hint) const {
    throw Error(ExitStatus::bad_data, {{{file_, std::max(1, line_number_), 1, {}}, message, hint}});
  }

  std::string_view text_;
  std::string file_, object_;
  std::string_view line_;
  std::size_t end_ = 0;  ///< past the line's end
  std::size_t at_ = 0, word_at_ = 0;
  int line_number_ = 0;
  bool in_object_ = false, in_group_ = false, found_ = false, colored_ = false;
  std::vector<std::string> names_;
  PlainMesh mesh_;
};

}  // namespace

PlainMesh parse_obj(std::string_view text, const std::string& file, const std::string& object) {
  return ObjParser(text, file, object).parse();
}

}  // namespace pomona
