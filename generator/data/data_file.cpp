#include "generator/data/data_file.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/base/small_ending.h"
#include "generator/knife/read_knife.h"
#include "generator/order/option_key.h"
#include "generator/scene/read_dish.h"
#include "generator/text/one_or_many.h"
#include "generator/text/read_name.h"
#include "generator/text/read_range.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t max_kinds = 1000;

Within number_law(const TomlValue& value, const Within& fallback, const Within& within) {
  return number_range(value, within).value_or(fallback);
}
Within angle_law(const TomlValue& value, const Within& fallback, const Within& degrees) {
  const auto read = [&](const TomlValue& end) { return end.angle(fallback.low, degrees); };
  return read_range<Within>(value, read).value_or(fallback);
}
Within length_law(const TomlValue& value, const Within& fallback, const Within& metres) {
  const auto read = [&](const TomlValue& end) { return end.length(fallback.low, metres); };
  return read_range<Within>(value, read).value_or(fallback);
}
WholeLaw whole_law(const TomlValue& value, const WholeLaw& fallback, int low, int high) {
  const auto read = [&](const TomlValue& end) { return end.integer(fallback.low, low, high); };
  return read_range<WholeLaw>(value, read).value_or(fallback);
}

template <typename Choice>
std::vector<Choice> read_choices(const TomlValue& value, std::vector<Choice> fallback,
                                 const std::vector<std::string>& names) {
  if (!value.given()) return fallback;
  std::vector<Choice> choices;
  for (const TomlValue& one : one_or_many(value)) choices.push_back(static_cast<Choice>(one.choice(names)));
  return choices.empty() ? fallback : choices;
}

/// The number of planes of "random" and "random:3"; nothing if it is another knife.
std::optional<int> random_planes_of(const TomlValue& value) {
  constexpr int max_planes = 8;
  const std::string text = value.is(TomlNode::Kind::string) ? value.text() : std::string();
  if (text == "random") return 1;
  if (!text.starts_with("random:")) return {};
  const std::string number = text.substr(7);
  const bool is_digit = number.size() == 1 && number[0] >= '1' && number[0] <= '0' + max_planes;
  if (!is_digit) value.error("is no number of random planes", "write random:1 to random:8");
  return is_digit ? number[0] - '0' : 1;
}

std::vector<KnifeLaw> read_cut(const TomlValue& value, const fs::path& folder) {
  const std::vector<TomlValue> words = value.is(TomlNode::Kind::array) ? value.values() : std::vector<TomlValue>{value};
  std::vector<KnifeLaw> knives;
  for (const TomlValue& word : words) {
    if (const auto planes = random_planes_of(word)) {
      knives.push_back({{}, *planes});
    } else if (std::optional<Knife> knife = read_knife(word, folder)) {
      knives.push_back({std::move(knife), 0});
    }
  }
  return knives;
}

/// A tree of TOML as JSON, for the record of a set.
nlohmann::ordered_json as_json(const TomlNode& node) {
  switch (node.kind) {
    case TomlNode::Kind::string:
    case TomlNode::Kind::date:
      return node.text;
    case TomlNode::Kind::integer:
      return node.integer;
    case TomlNode::Kind::number:
      return node.number;
    case TomlNode::Kind::boolean:
      return node.boolean;
    case TomlNode::Kind::array: {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const TomlNode& item : node.items) list.push_back(as_json(item));
      return list;
    }
    case TomlNode::Kind::table: {
      nlohmann::ordered_json table = nlohmann::ordered_json::object();
      for (const TomlEntry& entry : node.entries) table[entry.key] = as_json(entry.value);
      return table;
    }
  }
  return nullptr;
}

/// The laws of the file: all keys that a picture's bytes depend on.
std::string laws_of(std::string_view toml, const std::string& file) {
  nlohmann::ordered_json laws = as_json(parse_toml(toml, file));
  if (laws.contains("data") && laws["data"].is_object()) {
    for (const char* key : {"count", "split", "title", "description", "license", "url"}) laws["data"].erase(key);
  }
  return json_text(laws);
}

/// A picture, or all those in a folder, by name.
std::vector<fs::path> pictures_at(const fs::path& path, bool are_environments) {
  const auto is_picture = [&](const fs::path& file) {
    const std::string ending = small_ending(file);
    return ending == ".png" || (are_environments && ending == ".hdr");
  };
  std::error_code failed;
  std::vector<fs::path> found;
  if (fs::is_directory(path, failed)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path, failed))
      if (is_picture(entry.path())) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
  } else if (fs::is_regular_file(path, failed) && is_picture(path)) {
    found.push_back(path);
  }
  return found;
}

const char* endings_read(bool are_environments) {
  return are_environments ? "a .png or .hdr, or a folder of these" : "a .png, or a folder of these";
}

class DataReader {
 public:
  DataReader(std::string_view toml, const std::string& file)
      : document_(toml, file), folder_(fs::path(file).parent_path()) {
    data_.file = file;
    data_.laws = laws_of(toml, file);
  }

  DataDescription read() {
    const TomlTable root = document_.root();
    read_set(root.need("data").table());
    read_scene(root.get("scene").table());
    read_view(root.get("view").table());
    read_light(root.get("light").table());
    const TomlTable camera = root.get("camera").table();
    data_.camera.exposure = number_law(camera.get("exposure"), data_.camera.exposure, {-4, 4});
    data_.camera.blur = number_law(camera.get("blur"), data_.camera.blur, {0, 8});
    data_.camera.noise = number_law(camera.get("noise"), data_.camera.noise, {0, 0.5});
    read_ground(root.get("ground").table());
    const bool is_blurred_or_noisy = data_.camera.blur.high > 0 || data_.camera.noise.high > 0;
    if (data_.ground.transparent && is_blurred_or_noisy)
      root.get("ground")
          .table()
          .get("transparent")
          .error("and blur or noise of the camera exclude each other", "add these to what is composed");
    read_all_dishes(root.get("dishes"), root.get("scene").table());

    const std::vector<TomlTable> kinds = root.need("fruit").tables(max_kinds);
    if (root.has("fruit") && kinds.empty()) root.get("fruit").error("is empty", "say what pictures show: [[fruit]]");
    for (const TomlTable& kind : kinds) data_.kinds.push_back(read_kind(kind));
    document_.throw_if_any();
    return std::move(data_);
  }

 private:
  void read_set(const TomlTable& table) {
    table.need("format").integer(1, 1, 1);
    data_.name = read_name(table.need("name"), {});
    data_.title = table.get("title").text(data_.name);
    data_.description = table.get("description").text("Pictures of cut fruit and vegetables with exact ground truth");
    data_.license = table.get("license").text("https://creativecommons.org/publicdomain/zero/1.0/");
    data_.url = table.get("url").text();
    data_.seed = static_cast<std::uint64_t>(table.get("seed").integer(0, 0, std::numeric_limits<int>::max()));
    data_.count = table.need("count").integer(1, 1, max_data_pictures);
    read_size(table.get("size"));
    data_.quality = static_cast<Quality>(table.get("quality").choice(quality_names(), 0));
    data_.detail = table.get("detail").number(data_.detail, range_of(order_option("detail")));
    read_styles(table.get("style"));
    data_.layers = static_cast<DataLayers>(table.get("layers").choice({"none", "png", "exr"}, 1));
    data_.classes = static_cast<DataClasses>(table.get("classes").choice({"species", "state", "species and state"}, 0));
    data_.least_area = table.get("least_area").integer(data_.least_area, 1, 1'000'000);
    data_.models = table.get("models").boolean(false);
    read_split(table.get("split"));
  }

  void read_size(const TomlValue& value) {
    const std::vector<TomlValue> size = value.values(2, "needs two numbers", "write [width, height] in pixels");
    if (size.empty()) return;
    data_.width = size[0].integer(data_.width, 16, 4096);
    data_.height = size[1].integer(data_.height, 16, 4096);
  }

  void read_styles(const TomlValue& value) {
    if (!value.given()) return;
    data_.styles.clear();
    for (const TomlValue& one : one_or_many(value)) {
      data_.styles.push_back(one.text());
      data_.style_places.push_back(one.place());
    }
    if (data_.styles.empty()) data_.styles.emplace_back("ink");
  }

  void read_split(const TomlValue& value) {
    const std::string hint = "write [train, validation, test]: [8, 1, 1]";
    const std::vector<TomlValue> shares = value.values(3, "needs three shares", hint);
    if (shares.empty()) return;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += data_.split[i] = shares[i].number(0, {0, 1e6});
    if (!(sum > 0)) value.error("has no share above 0", hint);
    for (double& share : data_.split) share = sum > 0 ? share / sum : 0;
  }

  void read_scene(const TomlTable& table) {
    constexpr int max_fruits = 100;
    data_.fruits = whole_law(table.get("fruits"), data_.fruits, 1, max_fruits);
    data_.arrangements = read_choices(table.get("arrangement"), data_.arrangements, {"heap", "rows"});
    data_.spread = length_law(table.get("spread"), data_.spread, {0.005, 2});
    data_.dish = table.get("dish").number(0, {0, 1});
    data_.distractors = whole_law(table.get("distractors"), data_.distractors, 0, 20);
  }

  void read_view(const TomlTable& table) {
    DataView& view = data_.view;
    view.azimuth = angle_law(table.get("azimuth"), view.azimuth, {-720, 720});
    view.elevation = angle_law(table.get("elevation"), view.elevation, {1, 89});
    view.field = angle_law(table.get("field"), view.field, {1, 120});
    view.fit = number_law(table.get("fit"), view.fit, {0.1, 20});
    if (table.has("distance")) view.distance = length_law(table.get("distance"), {0.5, 0.5}, {0.01, 100});
    if (table.has("distance") && table.has("fit"))
      table.get("fit").error("and \"distance\" exclude each other", "keep one of them");
    view.shift = number_law(table.get("shift"), view.shift, {-0.5, 0.5});
  }

  void read_light(const TomlTable& table) {
    DataLight& light = data_.light;
    if (table.has("azimuth")) light.azimuth = angle_law(table.get("azimuth"), {}, {-720, 720});
    if (table.has("elevation")) light.elevation = angle_law(table.get("elevation"), {}, {5, 90});
    light.strength = number_range(table.get("strength"), {0, 4});
    light.ambient = number_range(table.get("ambient"), {0, 4});
    light.softness = number_range(table.get("softness"), {0, 1});
  }

  void read_ground(const TomlTable& table) {
    DataGround& ground = data_.ground;
    for (const TomlValue& paper : one_or_many(table.get("paper"))) ground.papers.push_back(paper.color());
    for (const TomlValue& picture : one_or_many(table.get("picture"))) add_pictures(picture, false);
    for (const TomlValue& around : one_or_many(table.get("environment"))) add_pictures(around, true);
    ground.share = table.get("share").number(1, {0, 1});
    const bool has_pictures = table.has("picture") || table.has("environment");
    if (table.has("share") && !has_pictures)
      table.get("share").error("is of pictures that are not named", "write picture = \"FOLDER\", or \"FILE.png\"");
    ground.transparent = table.get("transparent").boolean(false);
    if (ground.transparent && has_pictures)
      table.get("transparent").error("and pictures behind exclude each other", "keep one of them");
  }

  void add_pictures(const TomlValue& value, bool are_environments) {
    const std::string text = value.text();
    if (text.empty()) return;
    const std::vector<fs::path> found = pictures_at(folder_ / text, are_environments);
    if (found.empty())
      value.error("names no picture",
                  std::string("name ") + endings_read(are_environments) + ", from the file's folder");
    for (const fs::path& file : found) data_.ground.pictures.push_back({file, are_environments});
  }

  void read_all_dishes(const TomlValue& value, const TomlTable& scene) {
    std::vector<DishUse> uses;
    for (const TomlTable& table : value.given() ? value.tables() : std::vector<TomlTable>())
      uses.push_back(static_cast<DishUse>(table.get("use").choice({"in", "on", "beside"}, 2)));
    std::vector<DishDescription> dishes =
        value.given() ? read_dishes(value, folder_, {"bowl"}) : std::vector<DishDescription>();
    for (std::size_t i = 0; i < dishes.size(); ++i) data_.dishes.push_back({std::move(dishes[i]), uses[i]});
    const auto has = [&](bool beside) {
      return std::any_of(data_.dishes.begin(), data_.dishes.end(),
                         [&](const DataDish& dish) { return (dish.use == DishUse::beside) == beside; });
    };
    if (data_.dish > 0 && !has(false))
      scene.get("dish").error("needs [[dishes]] with use = \"in\" or \"on\"", "describe one, as in a scene");
    if (data_.distractors.high > 0 && !has(true))
      scene.get("distractors").error("needs [[dishes]] with use = \"beside\"", "describe one, as in a scene");
  }

  DataFruit read_kind(const TomlTable& unnamed) {
    DataFruit kind;
    const TomlTable table = unnamed.called("fruit \"" + unnamed.get("name").text() + "\"");
    kind.name = read_name(table.need("name"), names_);
    kind.place = table.get("name").place();
    names_.push_back(kind.name);
    const TomlValue wanted = table.need("templates");
    kind.all_templates = wanted.is(TomlNode::Kind::string) && wanted.text() == "all";
    if (!kind.all_templates)
      for (const TomlValue& value : one_or_many(wanted)) kind.templates.push_back({value.text(), value.place()});

    kind.share = table.get("share").number(1, {1e-6, 1e6});
    const std::vector<TomlValue> cuts = one_or_many(table.get("knives"));
    if (!cuts.empty()) kind.cuts.clear();
    for (const TomlValue& cut : cuts) kind.cuts.push_back(read_cut(cut, folder_));
    kind.pieces = whole_law(table.get("pieces"), kind.pieces, 1, 1000);
    kind.ripeness = number_range(table.get("ripeness"), range_of(order_option("ripeness")));
    kind.browning = number_range(table.get("browning"), range_of(order_option("browning")));
    kind.size = number_law(table.get("size"), kind.size, range_of(order_option("scale")));
    kind.variation = table.get("variation").number(1, range_of(order_option("variation")));
    kind.face_up = table.get("face_up").number(kind.face_up, {0, 1});
    return kind;
  }

  TomlDocument document_;
  fs::path folder_;
  DataDescription data_;
  std::vector<std::string> names_;  ///< of the kinds so far
};

}  // namespace

DataDescription parse_data(std::string_view toml, const std::string& file) { return DataReader(toml, file).read(); }

DataDescription read_data(const fs::path& file) { return parse_data(read_toml_text(file), file.string()); }

DataDescription with_backgrounds(DataDescription data, const BackgroundPaths& paths) {
  if (paths.pictures.empty() && paths.environments.empty()) return data;
  if (data.ground.transparent)
    throw Error(ExitStatus::usage, data.file + ": wants a transparent ground, which takes no --background");
  nlohmann::ordered_json laws = nlohmann::ordered_json::parse(data.laws);
  if (!laws.contains("ground")) laws["ground"] = nlohmann::ordered_json::object();
  data.ground.pictures.clear();
  for (const bool are_environments : {false, true}) {
    const char* key = are_environments ? "environment" : "picture";
    laws["ground"].erase(key);
    for (const std::string& path : are_environments ? paths.environments : paths.pictures) {
      const std::vector<fs::path> found = pictures_at(path, are_environments);
      if (found.empty())
        throw Error(ExitStatus::input_missing, path + ": is no picture",
                    std::string("name ") + endings_read(are_environments));
      for (const fs::path& file : found) {
        data.ground.pictures.push_back({file, are_environments});
        laws["ground"][key].push_back(file.filename().string());
      }
    }
  }
  data.laws = json_text(laws);
  return data;
}

bool is_data_file(const fs::path& file) { return has_toml_heading(file, {"[data]"}); }

}  // namespace pomona
