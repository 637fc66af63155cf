#include "generator/surface/file/ply.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "generator/surface/file/ply_header.h"

namespace pomona {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

template <typename T>
double decoded(const std::array<unsigned char, 8>& little_endian) {
  T value;
  std::memcpy(&value, little_endian.data(), sizeof(T));
  return static_cast<double>(value);
}

double decoded(PlyType type, const std::array<unsigned char, 8>& little_endian) {
  switch (type) {
    case PlyType::int8:
      return decoded<std::int8_t>(little_endian);
    case PlyType::uint8:
      return decoded<std::uint8_t>(little_endian);
    case PlyType::int16:
      return decoded<std::int16_t>(little_endian);
    case PlyType::uint16:
      return decoded<std::uint16_t>(little_endian);
    case PlyType::int32:
      return decoded<std::int32_t>(little_endian);
    case PlyType::uint32:
      return decoded<std::uint32_t>(little_endian);
    case PlyType::float32:
      return decoded<float>(little_endian);
    case PlyType::float64:
      return decoded<double>(little_endian);
  }
  return 0;
}

/// The minimum number of bytes of one item of an element.
std::uint64_t min_size(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& property : element.properties) {
    // In text, a digit and a separator.
    size += format == PlyFormat::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  }
  return size;
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyReader::PlyReader(std::string_view bytes, const std::string& file)
    : bytes_(bytes), file_(file), header_(parse_ply_header(bytes, file)) {
  static_assert(std::endian::native == std::endian::little, "decoded() copies bytes as they lie");
  next_ = last_ = header_.size;
  check_counts();
}

void PlyReader::check_counts() const {
  // The last value of a text needs no separator.
  std::uint64_t left = bytes_.size() - header_.size + (header_.format == PlyFormat::ascii ? 1 : 0);
  for (const PlyElement& element : header_.elements) {
    const std::uint64_t size = min_size(element, header_.format);
    if (size == 0) continue;
    if (element.count > left / size) {
      fail_at(element.byte,
              "the file is too short for " + std::to_string(element.count) + " of \"" + element.name + "\"");
    }
    left -= element.count * size;
  }
}

void PlyReader::start_item(const PlyElement& element, std::uint64_t index) {
  element_ = &element;
  index_ = index;
}

double PlyReader::value(PlyType type) {
  return header_.format == PlyFormat::ascii ? ascii_value() : binary_value(type);
}

double PlyReader::binary_value(PlyType type) {
  const std::size_t size = size_of(type);
  last_ = next_;
  if (bytes_.size() - next_ < size) fail("the file ends early");
  std::array<unsigned char, 8> little_endian{};
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t from = header_.format == PlyFormat::binary_big_endian ? size - 1 - k : k;
    little_endian[k] = static_cast<unsigned char>(bytes_[next_ + from]);
  }
  next_ += size;
  return decoded(type, little_endian);
}

double PlyReader::ascii_value() {
  while (next_ < bytes_.size() && is_space(bytes_[next_])) ++next_;
  last_ = next_;
  if (next_ == bytes_.size()) fail("the file ends early");
  while (next_ < bytes_.size() && !is_space(bytes_[next_])) ++next_;

  std::string_view text = bytes_.substr(last_, next_ - last_);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) fail("this is not a number");
  return value;
}

std::uint64_t PlyReader::list_length(const PlyProperty& list) {
  const double length = value(*list.count_type);
  const std::size_t item = header_.format == PlyFormat::ascii ? 2 : size_of(list.type);
  const std::uint64_t max = (bytes_.size() - next_ + 1) / item;
  if (!(length >= 0) || length != std::floor(length)) fail("a list cannot be that long");
  if (length > static_cast<double>(max)) fail("the file is too short for this list");
  return static_cast<std::uint64_t>(length);
}

void PlyReader::skip(const PlyProperty& property) {
  const std::uint64_t count = property.count_type ? list_length(property) : 1;
  for (std::uint64_t k = 0; k < count; ++k) value(property.type);
}

std::size_t PlyReader::bytes_left() const {
  std::size_t end = bytes_.size();
  while (end > next_ && (is_space(bytes_[end - 1]) || bytes_[end - 1] == '\0')) --end;
  return end - next_;
}

void PlyReader::fail(const std::string& message, const std::string& hint) const {
  if (header_.format == PlyFormat::ascii) fail_at(last_, message, hint);
  SourcePlace place;
  place.file = file_;
  place.element = (element_ ? element_->name + " " + std::to_string(index_) + ", " : std::string()) + "byte " +
                  std::to_string(last_);
  throw Error(ExitStatus::bad_data, {{place, message, hint}});
}

void PlyReader::fail_whole(const std::string& message, const std::string& hint) const {
  throw Error(ExitStatus::bad_data, {{{file_, 0, 0, {}}, message, hint}});
}

void PlyReader::fail_at(std::size_t byte, const std::string& message, const std::string& hint) const {
  throw Error(ExitStatus::bad_data, {{place_in_text(bytes_, byte, file_), message, hint}});
}

}  // namespace pomona
