#include "generator/text/json_node.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "generator/text/text_places.h"

namespace pomona {

namespace {

constexpr std::size_t max_levels = 32;
constexpr std::size_t max_values = 1'500'000;
constexpr std::size_t max_keys = 1000;  // limit of keys of an object, because each is compared with all before it

/// Reads characters and knows how many the parser has taken.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** reached = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    if (reached) *reached = at;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

[[noreturn]] void fail(const SourcePlace& place, const std::string& message) {
  throw Error(ExitStatus::bad_data, {{place, message, {}}});
}

/// Builds the tree from nlohmann's events. A value starts at the first character behind the last token.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& file)
      : text_(text), places_(text, file), file_(std::make_shared<const std::string>(file)) {}

  JsonNode run() {
    const char* const end = text_.data() + text_.size();
    nlohmann::json::sax_parse(CountingIterator{text_.data(), &reached_}, CountingIterator{end, nullptr}, this);
    return std::move(root_);
  }

  bool null() override { return add(JsonNode::Kind::null, 0), true; }
  bool boolean(bool value) override {
    add(JsonNode::Kind::boolean, 0).number = value ? 1 : 0;
    return true;
  }
  bool number_integer(std::int64_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) override { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) override { return number(value); }
  bool string(std::string& value) override {
    add(JsonNode::Kind::string, 0).text = value;
    return true;
  }
  bool binary(nlohmann::json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(JsonNode::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    const SourcePlace place = next_place(0);
    for (const std::string& known : open_.back()->keys)
      if (known == name) fail(place, "key \"" + name + "\" is there already");
    if (open_.back()->keys.size() == max_keys) fail(place, "an object with more than 1000 keys");
    open_.back()->keys.push_back(name);
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::json::exception& error) override {
    std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    const std::size_t colon = what.find(": ");
    if (colon != std::string::npos) what.erase(0, colon + 2);
    fail(places_.at(byte > 0 ? byte - 1 : 0), "this is not JSON: " + what);
  }

 private:
  /// The start of the token that was just read. The parser has read `ahead` characters beyond its end.
  SourcePlace next_place(std::size_t ahead) {
    while (last_end_ < text_.size() && std::string_view(" \t\r\n,:]}").find(text_[last_end_]) != std::string_view::npos)
      ++last_end_;
    const SourcePlace place = places_.at(last_end_);
    const auto reached = static_cast<std::size_t>(reached_ - text_.data());
    last_end_ = std::max(last_end_, reached - std::min(ahead, reached));
    return place;
  }

  JsonNode& add(JsonNode::Kind kind, std::size_t ahead) {
    JsonNode* node = &root_;
    if (!open_.empty()) node = &open_.back()->items.emplace_back();
    const SourcePlace place = next_place(ahead);
    if (++values_ > max_values) fail(place, "more than 1 500 000 values");
    node->kind = kind;
    node->line = place.line;
    node->column = place.column;
    node->file = file_;
    return *node;
  }

  bool number(double value) {
    add(JsonNode::Kind::number, 1).number = value;
    return true;
  }

  bool open(JsonNode::Kind kind) {
    JsonNode& node = add(kind, 0);
    open_.push_back(&node);
    if (open_.size() > max_levels) fail(node.place(), "nests deeper than " + std::to_string(max_levels) + " levels");
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  TextPlaces places_;
  std::shared_ptr<const std::string> file_;
  std::size_t values_ = 0;
  const char* reached_ = text_.data();
  std::size_t last_end_ = 0;
  JsonNode root_;
  std::vector<JsonNode*> open_;  ///< parents do not move while a child is open
};

}  // namespace

const JsonNode& JsonNode::need(std::string_view key) const {
  if (kind != Kind::object) fail(place(), "should be an object with \"" + std::string(key) + "\"");
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) return items[i];
  fail(place(), "\"" + std::string(key) + "\" is missing");
}

JsonNode parse_json(std::string_view text, const std::string& file) {
  if (text.size() > max_json_bytes) fail({file, 1, 1, {}}, "is larger than 64 MiB");
  return TreeBuilder(text, file).run();
}

}  // namespace pomona
