#include "cli/data/data_files.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/file_bytes.h"
#include "generator/base/json_text.h"
#include "generator/base/random.h"
#include "generator/base/sha256.h"
#include "generator/batch/batch_plan.h"
#include "generator/data/data_plan.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t max_annotations = std::size_t{1} << 30;  // bytes

/// A set as its record tells of it.
struct RecordedSet {
  Json record;
  DataDescription data;  ///< only what split_of() and class_of() need
  std::vector<std::string> classes;
  std::int64_t pictures = 0;
};

RecordedSet set_of(const std::string& record) {
  RecordedSet set{Json::parse(record), {}, {}, 0};
  set.data.seed = set.record["seed"];
  set.data.split = set.record["split"].get<std::array<double, 3>>();
  set.data.least_area = set.record["least_area"];
  const std::string kind = set.record["classes_are"];
  set.data.classes = kind == "species" ? DataClasses::species
                     : kind == "state" ? DataClasses::state
                                       : DataClasses::species_and_state;
  set.classes = set.record["classes"].get<std::vector<std::string>>();
  set.pictures = set.record["items"];
  return set;
}

/// One picture's annotations.json; nothing for one that failed.
Json annotations_of(const fs::path& folder, const RecordedSet& set, std::int64_t number) {
  const fs::path file = folder / item_path("pictures", set.pictures, number) / "annotations.json";
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return {};
  return Json::parse(file_bytes(file, max_annotations));
}

/// Numbers from 1 for keys, in the order in which they come.
class Numbers {
 public:
  std::size_t of(const std::string& key) {
    const auto [place, is_new] = numbers_.try_emplace(key, keys_.size() + 1);
    if (is_new) keys_.push_back(key);
    return place->second;
  }
  const std::vector<std::string>& keys() const { return keys_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> keys_;
};

/// One part of the set, written in passes over its pictures.
class SplitWriter {
 public:
  SplitWriter(const fs::path& folder, const RecordedSet& set, std::string_view split)
      : folder_(folder), set_(set), split_(split) {}

  void write_coco(const Workplace::Writer& write) {
    Json head = {{"description", set_.record["description"]}, {"made_by", set_.record["program"]}};
    const Json licenses = Json::array({{{"id", 1}, {"name", "license"}, {"url", set_.record["license"]}}});
    write("{\"info\":" + json_text(head) + ",\n\"licenses\":" + json_text(licenses) +
          ",\n\"categories\":" + json_text(categories()) + ",\n\"images\":[");
    each([&](std::int64_t number, const Json& one) { line(write, image_of(number, one)); });
    write_pieces(write, "annotations");
    write_pieces(write, "hidden");
    write_parts(write);
    write("\n],\n\"parts\":" + json_text(parts()) + "}\n");
  }

  /// The pictures' paths, for YOLO, whose labels lie beside them.
  void write_list(const Workplace::Writer& write) {
    each([&](std::int64_t number, const Json&) { write("./" + path_of(number) + "/picture.png\n"); });
  }

  /// How many pieces of each class and state.
  Json statistics() {
    Json all = {{"pictures", 0}, {"pieces", 0}, {"classes", Json::object()}, {"states", Json::object()}};
    for (const std::string& name : set_.classes) all["classes"][name] = 0;
    each([&](std::int64_t, const Json& one) {
      all["pictures"] = all["pictures"].get<int>() + 1;
      for (const Json& piece : one["annotations"]) {
        const int index = class_of_piece(one, piece);
        if (index < 0) continue;
        for (Json* count : {&all["pieces"], &all["classes"][set_.classes[static_cast<std::size_t>(index)]],
                            &all["states"][piece["state"].get<std::string>()]})
          *count = count->is_null() ? 1 : count->get<int>() + 1;
      }
    });
    return all;
  }

 private:
  void each(const std::function<void(std::int64_t, const Json&)>& visit) {
    is_first_ = true;
    for (std::int64_t number = 0; number < set_.pictures; ++number) {
      if (split_of(set_.data, number) != split_) continue;
      const Json one = annotations_of(folder_, set_, number);
      if (!one.is_null()) visit(number, one);
    }
  }

  void line(const Workplace::Writer& write, const Json& json) {
    write((is_first_ ? "\n" : ",\n") + json_text(json));
    is_first_ = false;
  }

  std::string path_of(std::int64_t number) const { return item_path("pictures", set_.pictures, number); }

  static std::string species_of(const Json& one, const Json& piece) {
    return one["categories"][piece["category_id"].get<std::size_t>() - 1]["name"];
  }

  /// An index into the classes; -1 for what is no annotation of the set.
  int class_of_piece(const Json& one, const Json& piece) const {
    if (!piece.contains("state")) return -1;
    const std::string name = class_of(set_.data.classes, species_of(one, piece), piece["state"].get<std::string>());
    const auto found = std::find(set_.classes.begin(), set_.classes.end(), name);
    return found == set_.classes.end() ? -1 : static_cast<int>(found - set_.classes.begin());
  }

  bool is_large_enough(const Json& piece) const { return piece["area"].get<int>() >= set_.data.least_area; }

  Json categories() const {
    Json list = Json::array();
    for (const std::string& name : set_.classes)
      list.push_back({{"id", list.size() + 1}, {"name", name}, {"supercategory", "object"}});
    return list;
  }

  Json parts() const {
    Json list = Json::array();
    for (const std::string& key : parts_.keys()) {
      const std::size_t dot = key.find('.');
      list.push_back({{"id", list.size() + 1}, {"name", key.substr(dot + 1)}, {"species", key.substr(0, dot)}});
    }
    return list;
  }

  std::size_t part_number(const Json& one, const Json& part) {
    return parts_.of(species_of(one, part) + "." + part["name"].get<std::string>());
  }

  Json image_of(std::int64_t number, const Json& one) {
    Json image = one["images"][0];
    image["id"] = number + 1;
    image["file_name"] = path_of(number) + "/picture.png";
    for (Json& layer : image["layers"]) layer = path_of(number) + "/" + layer.get<std::string>();
    image["license"] = 1;
    image["parts"] = Json::object();
    for (const Json& part : one["parts"])
      image["parts"][std::to_string(part["id"].get<int>())] = part_number(one, part);
    return image;
  }

  void write_pieces(const Workplace::Writer& write, const char* list) {
    write("\n],\n\"" + std::string(list) + "\":[");
    each([&](std::int64_t number, const Json& one) {
      for (const Json& piece : one[list]) {
        const int index = class_of_piece(one, piece);
        const bool is_annotation = std::string_view(list) == "annotations";
        if (index < 0 || (is_annotation && !is_large_enough(piece))) continue;
        Json entry = piece;
        entry["instance"] = piece["id"];
        entry["species"] = species_of(one, piece);
        entry["id"] = ++last_id_;
        entry["image_id"] = number + 1;
        entry["category_id"] = index + 1;
        line(write, entry);
      }
    });
  }

  void write_parts(const Workplace::Writer& write) {
    write("\n],\n\"part_annotations\":[");
    std::size_t last = 0;
    each([&](std::int64_t number, const Json& one) {
      for (const Json& part : one["part_annotations"]) {
        const Json& named = one["parts"][part["part_id"].get<std::size_t>() - 1];
        Json entry = part;
        entry["id"] = ++last;
        entry["image_id"] = number + 1;
        entry.erase("annotation_id");
        entry["instance"] = part["annotation_id"];
        entry["part_id"] = part_number(one, named);
        line(write, entry);
      }
    });
  }

  const fs::path& folder_;
  const RecordedSet& set_;
  std::string split_;
  Numbers parts_;
  std::size_t last_id_ = 0;
  bool is_first_ = true;
};

/// The context that the Croissant specification gives for version 1.0.
Json croissant_context() {
  Json context = {{"@language", "en"}, {"@vocab", "https://schema.org/"}};
  for (const char* term :
       {"citeAs",     "column",        "extract",  "field",   "fileProperty", "fileObject",  "fileSet",  "format",
        "includes",   "isLiveDataset", "jsonPath", "key",     "md5",          "parentField", "path",     "recordSet",
        "references", "regex",         "repeated", "replace", "separator",    "source",      "subField", "transform"})
    context[term] = std::string("cr:") + term;
  context["conformsTo"] = "dct:conformsTo";
  context["cr"] = "http://mlcommons.org/croissant/";
  context["rai"] = "http://mlcommons.org/croissant/RAI/";
  context["dct"] = "http://purl.org/dc/terms/";
  context["sc"] = "https://schema.org/";
  context["data"] = {{"@id", "cr:data"}, {"@type", "@json"}};
  context["examples"] = {{"@id", "cr:examples"}, {"@type", "@json"}};
  context["dataType"] = {{"@id", "cr:dataType"}, {"@type", "@vocab"}};
  return context;
}

/// Records out of one of the files of annotations: a field for each of these keys.
Json record_set(const std::string& split, const std::string& list,
                std::initializer_list<std::pair<const char*, const char*>> fields) {
  const std::string name = split + "-" + list;
  Json set = {{"@type", "cr:RecordSet"}, {"@id", name}, {"name", name}, {"field", Json::array()}};
  for (const auto& [key, type] : fields) {
    set["field"].push_back(
        {{"@type", "cr:Field"},
         {"@id", name + "/" + key},
         {"name", key},
         {"dataType", type},
         {"source", {{"fileObject", {{"@id", split}}}, {"extract", {{"jsonPath", "$." + list + "[*]." + key}}}}}});
  }
  return set;
}

Json croissant(const fs::path& folder, const RecordedSet& set) {
  const char *whole = "sc:Integer", *number = "sc:Float", *text = "sc:Text";
  Json files = Json::array(), records = Json::array();
  for (const std::string_view split : split_names) {
    const std::string name(split);
    files.push_back({{"@type", "cr:FileObject"},
                     {"@id", name},
                     {"name", name},
                     {"contentUrl", name + ".json"},
                     {"encodingFormat", "application/json"},
                     {"sha256", sha256(file_bytes(folder / (name + ".json"), max_annotations))}});
    records.push_back(record_set(name, "images", {{"id", whole}, {"file_name", text}, {"command", text}}));
    records.push_back(record_set(name, "annotations",
                                 {{"id", whole},
                                  {"image_id", whole},
                                  {"category_id", whole},
                                  {"instance", whole},
                                  {"species", text},
                                  {"state", text},
                                  {"area", whole},
                                  {"occlusion", number},
                                  {"volume", number},
                                  {"mass", number}}));
  }
  files.push_back({{"@type", "cr:FileSet"},
                   {"@id", "picture-files"},
                   {"name", "picture-files"},
                   {"encodingFormat", "image/png"},
                   {"includes", "pictures/**/picture.png"}});
  Json described = {{"@context", croissant_context()},
                    {"@type", "sc:Dataset"},
                    {"conformsTo", "http://mlcommons.org/croissant/1.0"},
                    {"name", set.record["name"]},
                    {"description", set.record["description"]},
                    {"license", set.record["license"]}};
  if (!set.record["url"].get<std::string>().empty()) described["url"] = set.record["url"];
  described["version"] = "1.0.0";
  described["distribution"] = files;
  described["recordSet"] = records;
  return described;
}

/// What YOLO's trainers read.
std::string yolo_yaml(const RecordedSet& set) {
  std::string yaml = "path: .\ntrain: train.txt\nval: validation.txt\ntest: test.txt\nnames:\n";
  for (std::size_t i = 0; i < set.classes.size(); ++i) yaml += "  " + std::to_string(i) + ": " + set.classes[i] + "\n";
  return yaml;
}

}  // namespace

bool is_data_record(const std::string& record) {
  const Json json = Json::parse(record, nullptr, false);
  return json.is_object() && json.value("kind", "") == "data";
}

void write_data_files(Workplace& workplace, const std::string& record) {
  const RecordedSet set = set_of(record);
  const fs::path& folder = workplace.folder();
  const auto put = [&](const std::string& name, const std::string& bytes) {
    workplace.put_file(name, [&](const Workplace::Writer& write) { write(bytes); });
  };
  Json statistics = Json::object();
  for (const std::string_view split : split_names) {
    SplitWriter writer(folder, set, split);
    const std::string name(split);
    workplace.put_file(name + ".json", [&](const Workplace::Writer& write) { writer.write_coco(write); });
    workplace.put_file(name + ".txt", [&](const Workplace::Writer& write) { writer.write_list(write); });
    statistics[name] = writer.statistics();
  }
  std::string classes;
  for (const std::string& name : set.classes) classes += name + "\n";
  put("classes.txt", classes);
  put("data.yaml", yolo_yaml(set));
  put("statistics.json", json_text(statistics, 1) + "\n");
  put("croissant.json", json_text(croissant(folder, set), 1) + "\n");
}

}  // namespace pomona
