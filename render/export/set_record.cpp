#include "render/export/set_record.h"

#include <charconv>
#include <utility>

namespace pomona {

namespace {

// Fields end with a byte that no path holds.
constexpr char field_end = '\0';
constexpr std::string_view heading = "pomona set 1", trailer = "whole";

class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : bytes_(bytes) {}

  std::string text() {
    const std::size_t end = bytes_.find(field_end);
    if (end == std::string_view::npos) {
      good_ = false;
      return {};
    }
    std::string field(bytes_.substr(0, end));
    bytes_.remove_prefix(end + 1);
    return field;
  }

  std::uint64_t number() {
    const std::string field = text();
    std::uint64_t value = 0;
    const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (fault != std::errc() || end != field.data() + field.size()) good_ = false;
    return value;
  }

  /// A number of further fields, of which each takes at least one byte.
  std::uint64_t count() {
    const std::uint64_t value = number();
    if (value > bytes_.size()) good_ = false;
    return good_ ? value : 0;
  }

  bool good() const { return good_; }

 private:
  std::string_view bytes_;
  bool good_ = true;
};

/// A name that stays in its folder.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

}  // namespace

std::string record_bytes(const SetRecord& record) {
  std::string bytes;
  const auto add = [&](std::string_view field) { bytes.append(field).push_back(field_end); };
  add(heading);
  add(record.leader.native());
  add(std::to_string(record.followers.size()));
  for (const std::filesystem::path& follower : record.followers) add(follower.native());
  add(std::to_string(record.members.size()));
  for (const SetMember& member : record.members) {
    add(member.name);
    add(std::to_string(member.inode));
    add(member.replaces ? "1" : "0");
  }
  add(trailer);
  return bytes;
}

std::optional<SetRecord> parse_record(std::string_view bytes) {
  FieldReader fields(bytes);
  if (fields.text() != heading) return {};
  SetRecord record;
  record.leader = fields.text();
  for (std::uint64_t left = fields.count(); left > 0 && fields.good(); --left)
    record.followers.emplace_back(fields.text());
  for (std::uint64_t left = fields.count(); left > 0 && fields.good(); --left) {
    SetMember member;
    member.name = fields.text();
    member.inode = fields.number();
    member.replaces = fields.number() == 1;
    if (!is_plain_name(member.name)) return {};
    record.members.push_back(std::move(member));
  }
  if (fields.text() != trailer || !fields.good()) return {};
  record.undone = fields.text() == "undo";
  return record;
}

}  // namespace pomona
