#include "generator/batch/batch_file.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "generator/batch/batch_limits.h"
#include "generator/knife/read_knife.h"
#include "generator/order/option_key.h"
#include "generator/template/template.h"
#include "generator/text/one_or_many.h"
#include "generator/text/read_name.h"
#include "generator/text/toml_document.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

constexpr int largest_seed = std::numeric_limits<int>::max();

/// Each read by `read`; what stood there before where nothing is given. No two may be the same: their items would be.
template <typename Value, typename Read>
void read_list(const TomlValue& list, std::vector<Value>& values, Read&& read) {
  const std::vector<TomlValue> given = one_or_many(list);
  if (given.empty()) return;
  values.clear();
  for (const TomlValue& value : given) {
    const Value next = read(value);
    if (std::find(values.begin(), values.end(), next) != values.end()) {
      value.error("is there already", "leave one of them out");
    } else {
      values.push_back(next);
    }
  }
}

/// Everything that `cut` and `grow` write, but for pictures of solids.
std::vector<std::string> batch_format_names() {
  std::vector<std::string> names;
  for (const std::string& name : format_names())
    if (name != "png" && name != "json") names.push_back(name);
  return names;
}

Format read_format(const TomlValue& value) {
  if (value.is(TomlNode::Kind::string) && value.text() == "png") {
    value.error("\"png\" is no format of a batch: OpenGL draws it otherwise on every machine",
                "thumbnail = 256 draws a picture of each item");
    return Format::glb;
  }
  const std::vector<std::string> names = batch_format_names();
  return format_called(names[static_cast<std::size_t>(value.choice(names))]).value_or(Format::glb);
}

/// A value of an option that is a whole number, as one of a list.
int read_whole(const TomlValue& value, const char* name) {
  const Within range = range_of(order_option(name));
  const int number = value.integer(0, 0, static_cast<int>(range.high));
  if (number > 0 && number < range.low)
    value.error("is below " + std::to_string(static_cast<int>(range.low)) + " " + order_option(name).unit, "0 is none");
  return number;
}

AssetOptions read_assets(const TomlTable& table, AssetOptions assets) {
  // Lists multiply ...
  read_list(table.get("formats"), assets.formats, read_format);
  read_list(table.get("quality"), assets.qualities,
            [](const TomlValue& value) { return static_cast<Quality>(value.choice(quality_names())); });
  read_list(table.get("texture"), assets.textures, [](const TomlValue& value) { return read_whole(value, "texture"); });
  read_list(table.get("lod"), assets.lods, [](const TomlValue& value) { return read_whole(value, "lod"); });

  // ... all else is the same for each item.
  for (const OrderOption* option : batch_options()) read_option_key(*option, table, assets.order);
  if (table.has("texel") && table.has("texture"))
    table.get("texel").error("and \"texture\" exclude each other", "keep one of them");
  assets.thumbnail = table.get("thumbnail").integer(assets.thumbnail, 0, 1024);
  if (table.has("thumbnail") && assets.thumbnail > 0 && assets.thumbnail < 16)
    table.get("thumbnail").error("is below 16 pixels", "0 draws none");
  assets.thumbnail_on_paper =
      table.get("thumbnail_ground").choice({"transparent", "paper"}, assets.thumbnail_on_paper ? 1 : 0) == 1;
  assets.on_table = table.get("layout").choice({"grown", "table"}, assets.on_table ? 1 : 0) == 1;
  assets.apart = table.get("pieces").choice({"together", "apart"}, assets.apart ? 1 : 0) == 1;
  return assets;
}

/// One knife, or several that cut one after another; none leave the fruit whole.
std::vector<Knife> read_alternative(const TomlValue& knives, const std::filesystem::path& folder) {
  if (knives.is(TomlNode::Kind::array)) return read_knives(knives.values(), folder);
  return read_knives({&knives, 1}, folder);
}

class BatchReader {
 public:
  BatchReader(std::string_view toml, const std::string& file) : document_(toml, file), file_(file) {}

  BatchDescription read() {
    const TomlTable root = document_.root();
    const TomlTable table = root.need("batch").table();
    batch_.file = file_;
    table.need("format").integer(1, 1, 1);
    batch_.name = read_name(table.need("name"), {});
    batch_.title = table.get("title").text(batch_.name);
    batch_.seed = static_cast<std::uint64_t>(table.get("seed").integer(0, 0, largest_seed));
    const AssetOptions usual = read_assets(table, {});

    const std::vector<TomlTable> entries = root.need("entry").tables(max_batch_entries);
    if (root.has("entry") && entries.empty()) root.get("entry").error("is empty", "say what to make: [[entry]]");
    for (const TomlTable& entry : entries) batch_.entries.push_back(read_entry(entry, usual));
    document_.throw_if_any();
    return std::move(batch_);
  }

 private:
  BatchEntry read_entry(const TomlTable& unnamed, const AssetOptions& usual) {
    // Messages call the entry by its name, which no other entry may have.
    BatchEntry entry;
    const TomlTable table = unnamed.called("entry \"" + unnamed.get("name").text() + "\"");
    const TomlValue name = table.need("name");
    entry.name = read_name(name, names_);
    entry.place = name.place();
    names_.push_back(entry.name);

    // Which fruit, and which individuals of it.
    read_templates(table, entry);
    read_variants(table, entry);
    read_list(table.get("folds"), entry.folds,
              [](const TomlValue& value) { return std::optional(value.integer(1, 1, max_folds)); });
    read_list(table.get("ripeness"), entry.ripeness, [](const TomlValue& value) {
      return std::optional(value.number(1, range_of(order_option("ripeness"))));
    });

    // Reads how it is cut and made, and the files.
    read_list(table.get("browning"), entry.browning,
              [](const TomlValue& value) { return value.number(0, range_of(order_option("browning"))); });
    const std::vector<TomlValue> alternatives = one_or_many(table.get("knives"));
    if (!alternatives.empty()) entry.knives.clear();
    for (const TomlValue& alternative : alternatives) entry.knives.push_back(read_alternative(alternative, folder()));
    entry.assets = read_assets(table, usual);
    return entry;
  }

  std::filesystem::path folder() const { return std::filesystem::path(file_).parent_path(); }

  void read_templates(const TomlTable& table, BatchEntry& entry) {
    const TomlValue wanted = table.need("templates");
    entry.all_templates = wanted.is(TomlNode::Kind::string) && wanted.text() == "all";
    if (entry.all_templates) return;
    for (const TomlValue& value : one_or_many(wanted)) {
      const std::string name = value.text();
      const auto is_known = [&](const TemplateWanted& other) { return other.name == name; };
      if (value.is(TomlNode::Kind::string) && name.empty()) value.error("is empty");
      if (std::any_of(entry.templates.begin(), entry.templates.end(), is_known))
        value.error("\"" + name + "\" is there already", "leave one of them out");
      entry.templates.push_back({name, value.place()});
    }
  }

  void read_variants(const TomlTable& table, BatchEntry& entry) {
    read_list(table.get("seeds"), entry.seeds,
              [](const TomlValue& value) { return static_cast<std::uint64_t>(value.integer(0, 0, largest_seed)); });
    entry.count = table.get("count").integer(0, 1, max_batch_items);
    entry.total = table.get("total").integer(0, 1, max_batch_items);
    const int given = (table.has("seeds") ? 1 : 0) + (table.has("count") ? 1 : 0) + (table.has("total") ? 1 : 0);
    if (given != 1)
      table.error("needs \"seeds\", \"count\" or \"total\", and one of them alone",
                  "count = 10 is ten new variants of each template, total = 10 ten of all templates in turn");
  }

  TomlDocument document_;
  std::string file_;
  BatchDescription batch_;
  std::vector<std::string> names_;  ///< names of the entries so far
};

}  // namespace

Order usual_batch_order() {
  Order order;
  order.mesh.maps = Maps::color;
  return order;
}

std::vector<const OrderOption*> batch_options() {
  constexpr std::array lists = {"quality", "texture", "lod", "folds", "ripeness", "browning", "knife"};
  std::vector<const OrderOption*> options;
  for (const OrderOption& option : order_options()) {
    const bool is_list = std::find(lists.begin(), lists.end(), option.name) != lists.end();
    if (has_option(OrderTaker::batch, option) && !is_list) options.push_back(&option);
  }
  return options;
}

BatchDescription parse_batch(std::string_view toml, const std::string& file) { return BatchReader(toml, file).read(); }

BatchDescription read_batch(const std::filesystem::path& file) {
  return parse_batch(read_toml_text(file), file.string());
}

bool is_batch_file(const std::filesystem::path& file) { return has_toml_heading(file, {"[batch]", "[[entry]]"}); }

}  // namespace pomona
