#include "cli/studio/flat_json.h"

#include <cstddef>
#include <utility>

namespace pomona {

namespace {

using nlohmann::json;

constexpr std::size_t max_keys = 32;

/// Receives the parser's events; a false result stops the parser.
class FlatObject final : public nlohmann::json_sax<json> {
 public:
  json take() { return std::move(object_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t& /*spelling*/) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*elements*/) override {
    if (!object_.is_null()) return false;
    object_ = json::object();
    return true;
  }
  bool key(string_t& name) override {
    key_ = std::move(name);
    return ++keys_ <= max_keys;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*elements*/) override { return false; }
  bool end_array() override { return false; }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/, const json::exception& /*error*/) override {
    return false;
  }

 private:
  bool put(json value) {
    if (!object_.is_object()) return false;
    object_[key_] = std::move(value);
    return true;
  }

  json object_;
  std::string key_;
  std::size_t keys_ = 0;
};

}  // namespace

json parse_flat_json(const std::string& text) {
  FlatObject object;
  return json::sax_parse(text, &object) ? object.take() : json();
}

}  // namespace pomona
