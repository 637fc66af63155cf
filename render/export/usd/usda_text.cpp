#include "render/export/usd/usda_text.h"

#include <array>
#include <charconv>

#include "generator/base/utf8.h"

namespace pomona::usd {

namespace {

template <typename Number>
void append(std::string& text, Number number) {
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

void append_tuple(std::string& text, const glm::dvec3& v, double step) {
  text += '(';
  append_number(text, v.x, step);
  text += ", ";
  append_number(text, v.y, step);
  text += ", ";
  append_number(text, v.z, step);
  text += ')';
}

}  // namespace

std::string tuple(const glm::dvec3& v, double step) {
  std::string text;
  append_tuple(text, v, step);
  return text;
}

std::string exact_tuple(const glm::dvec3& v) { return "(" + exact(v.x) + ", " + exact(v.y) + ", " + exact(v.z) + ")"; }

std::string exact_tuple(const glm::dquat& q) {
  return "(" + exact(q.w) + ", " + exact(q.x) + ", " + exact(q.y) + ", " + exact(q.z) + ")";
}

std::string list(std::span<const glm::vec3> values, double step) {
  std::string text = "[";
  for (const glm::vec3& value : values) {
    if (text.size() > 1) text += ", ";
    append_tuple(text, glm::dvec3(value), step);
  }
  return text + "]";
}

std::string list(std::span<const glm::vec2> values, double step) {
  std::string text = "[";
  for (const glm::vec2& value : values) {
    text += text.size() > 1 ? ", (" : "(";
    append_number(text, value.x, step);
    text += ", ";
    append_number(text, value.y, step);
    text += ')';
  }
  return text + "]";
}

std::string list(std::span<const std::int32_t> values) {
  std::string text = "[";
  for (const std::int32_t value : values) {
    if (text.size() > 1) text += ", ";
    append(text, value);
  }
  return text + "]";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : as_utf8(text)) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 32) {
      result += ' ';
    } else {
      result += c;
    }
  }
  return result + '"';
}

void append_line(std::string& text, int indent, const std::string& line) {
  text.append(static_cast<std::size_t>(4 * indent), ' ');
  text += line + "\n";
}

std::string asset(const std::string& file) {
  if (file.find('@') == std::string::npos) return "@./" + file + "@";
  // Three of these signs would end the path, also two at the end of the name [openusd.org, "Asset"].
  std::string escaped;
  for (std::size_t i = 0; i < file.size();) {
    const bool is_end = std::string_view(file).substr(i).starts_with("@@@");
    escaped += is_end ? "\\@@@" : std::string(1, file[i]);
    i += is_end ? 3 : 1;
  }
  return "@@@./" + escaped + "@@@";
}

std::string PrimNames::name_for(const std::string& wanted) {
  std::string name;
  for (const char c : wanted) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += is_plain ? c : '_';
  }
  if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name = "_" + name;
  std::string unique = name;
  for (int number = 2; !taken_.insert(unique).second; ++number) unique = name + "_" + std::to_string(number);
  return unique;
}

}  // namespace pomona::usd
