#include "cli/studio/studio_api.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/exhausted.h"
#include "cli/studio/flat_json.h"
#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/little_endian.h"
#include "generator/base/path_within.h"
#include "render/deliver/live_files.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::uintmax_t max_picture_bytes = std::uintmax_t{64} << 20;
constexpr int max_at_work = 12;  // a browser sends six at a time
constexpr std::string_view binary = "application/octet-stream";

WebReply json_reply(int status, const ordered_json& body) { return {status, "application/json", json_text(body)}; }

WebReply error_reply(int status, const std::string& message, const std::string& hint = {}) {
  return json_reply(status, {{"errors", {{{"message", message}, {"hint", hint}}}}});
}

/// The text without the folder: "kiwi.svg:12:5".
std::string without_folder(std::string text, const fs::path& file) {
  const std::string folder = file.parent_path().string();
  if (folder.empty()) return text;
  for (std::size_t at = text.find(folder + "/"); at != std::string::npos; at = text.find(folder + "/", at))
    text.erase(at, folder.size() + 1);
  return text;
}

/// The reader names a curve and its place in the drawing within the message: "skin" (kiwi.svg:12:5).
ordered_json error_of(const Diagnostic& diagnostic, const fs::path& file) {
  ordered_json error = {{"file", without_folder(diagnostic.place.file, file)},
                        {"line", diagnostic.place.line},
                        {"column", diagnostic.place.column},
                        {"message", without_folder(diagnostic.message, file)},
                        {"hint", without_folder(diagnostic.hint, file)}};
  static const std::regex place(R"re("([^"]{0,100})" \([^()]{0,300}:(\d{1,9}):(\d{1,9})\))re");
  std::smatch found;
  const std::string text = error["message"];
  if (text.size() < 2000 && std::regex_search(text, found, place)) {
    error["curve"] = found[1].str();
    error["svg_line"] = std::stoi(found[2].str());
    error["svg_column"] = std::stoi(found[3].str());
  }
  return error;
}

json parsed(const std::string& body) {
  json wanted = parse_flat_json(body);
  if (!wanted.is_object()) throw Error(ExitStatus::usage, "that is no JSON object of texts and numbers");
  return wanted;
}

std::string text_in(const json& wanted, const char* key) {
  if (!wanted.contains(key) || !wanted[key].is_string())
    throw Error(ExitStatus::usage, std::string(key) + " is missing, or no text");
  return wanted[key];
}

/// A number within bounds; `otherwise` if it is missing or null.
double number_in(const json& wanted, const char* key, double otherwise, double min, double max) {
  if (!wanted.contains(key) || wanted[key].is_null()) return otherwise;
  if (!wanted[key].is_number() || !(wanted[key].get<double>() >= min && wanted[key].get<double>() <= max))
    throw Error(ExitStatus::usage,
                std::string(key) + " is not a number from " + std::to_string(min) + " to " + std::to_string(max));
  return wanted[key];
}

std::uint64_t version_in(const json& wanted) {
  return static_cast<std::uint64_t>(number_in(wanted, "seen", 0, 0, 9e15));
}

FruitTexts texts_in(const json& wanted) { return {text_in(wanted, "toml"), text_in(wanted, "svg")}; }

WantedFruit fruit_in(const json& wanted) {
  WantedFruit fruit;
  fruit.texts = texts_in(wanted);
  fruit.seed = static_cast<std::uint64_t>(number_in(wanted, "seed", 0, 0, 9e15));
  if (const double folds = number_in(wanted, "folds", 0, 0, 64); folds >= 1) fruit.folds = static_cast<int>(folds);
  if (const double ripeness = number_in(wanted, "ripeness", -1, -1, 2); ripeness >= 0) fruit.ripeness = ripeness;
  fruit.browning = number_in(wanted, "browning", 0, 0, 1);
  fruit.detail = number_in(wanted, "detail", 1, 0.1, 1);
  fruit.draft = !(wanted.contains("final") && wanted["final"] == true);
  return fruit;
}

ordered_json numbers_of(const std::optional<SvgTransform>& t) {
  if (!t) return nullptr;
  return {t->a, t->b, t->c, t->d, t->e, t->f};
}

ordered_json numbers_of(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// The length of a JSON header, the header, then the pixels of all pictures.
std::string packed(const StudioFruit& fruit, const std::vector<SectionPicture>& pictures) {
  ordered_json head = {{"parts", fruit.source.fruit.parts},
                       {"drawing", {{"side", numbers_of(fruit.drawn.side)}, {"top", numbers_of(fruit.drawn.top)}}},
                       {"pictures", ordered_json::array()}};
  for (const SectionPicture& picture : pictures) {
    const PictureFrame& frame = picture.frame;
    head["pictures"].push_back({{"view", picture.view},
                                {"width", frame.width},
                                {"height", frame.height},
                                {"corner", numbers_of(frame.corner)},
                                {"right", numbers_of(frame.right)},
                                {"down", numbers_of(frame.down)}});
  }
  const std::string text = json_text(head);
  std::string bytes = word_bytes(text.size()) + text;
  for (const SectionPicture& picture : pictures) bytes.append(picture.pixels.begin(), picture.pixels.end());
  return bytes;
}

int status_for(const Error& error) {
  if (error.status() == ExitStatus::usage) return 400;
  const bool in_texts = error.status() == ExitStatus::bad_data || error.status() == ExitStatus::input_missing;
  return in_texts ? 422 : 500;
}

}  // namespace

StudioApi::StudioApi(Workspace& workspace, std::string page)
    : workspace_(workspace), fruits_(workspace.files().toml), page_(std::move(page)) {}

WebReply StudioApi::answer(const WebRequest& request) {
  try {
    return routed(request);
  } catch (const Error& error) {
    ordered_json errors = ordered_json::array();
    for (const Diagnostic& diagnostic : error.diagnostics())
      errors.push_back(error_of(diagnostic, workspace_.files().toml));
    return json_reply(status_for(error), {{"errors", errors}});
  } catch (const std::exception& error) {
    if (const auto lack = exhausted(error))
      return error_reply(500, std::string(*lack), "fewer triangles need less: lower around and along");
    return error_reply(500, std::string("this is a bug in pomona: ") + error.what());
  }
}

WebReply StudioApi::routed(const WebRequest& request) {
  const std::string& path = request.path;
  if (request.method == "GET") {
    if (path == "/") return {200, "text/html; charset=utf-8", page_};
    if (path == "/api/document") return document(true);
    if (path == "/api/state") return document(false);
    if (path == "/api/picture") return made(request);
  } else {
    if (path == "/api/change") return change(request.body);
    if (path == "/api/save") return save(request.body);
    if (path == "/api/revert") return revert(request.body);
    if (path == "/api/section" || path == "/api/asset") return made(request);
  }
  return error_reply(404, "there is nothing at this path");
}

/// Long or large work never takes all threads, so that edits can be kept and saved meanwhile.
WebReply StudioApi::made(const WebRequest& request) {
  if (++at_work_ > max_at_work) {
    --at_work_;
    return error_reply(503, "the studio is at work on other fruits", "ask again when these are there");
  }
  const std::unique_ptr<std::atomic<int>, void (*)(std::atomic<int>*)> done(&at_work_, [](auto* count) { --*count; });
  if (request.path == "/api/asset") return asset(request.body);
  if (request.path == "/api/section") return section(request.body);
  const auto href = request.query.find("href");
  return picture(href == request.query.end() ? std::string() : href->second);
}

WebReply StudioApi::document(bool with_texts) {
  const WorkspaceState state = workspace_.state();
  const WorkspaceFiles& files = workspace_.files();
  ordered_json description = {{"version", state.version},
                              {"unsaved", state.unsaved},
                              {"recovered", state.recovered},
                              {"changed_outside", state.changed_outside}};
  if (!with_texts) return json_reply(200, description);
  description.update({{"name", files.toml.stem().string()},
                      {"toml_file", files.toml.filename().string()},
                      {"svg_file", files.svg.filename().string()},
                      {"toml", state.texts.toml},
                      {"svg", state.texts.svg}});
  return json_reply(200, description);
}

WebReply StudioApi::change(const std::string& body) {
  const json wanted = parsed(body);
  const std::optional<std::uint64_t> version = workspace_.change(version_in(wanted), texts_in(wanted));
  if (!version)
    return error_reply(409, "the fruit was changed elsewhere in the meantime", "another window has it open");
  return json_reply(200, {{"version", *version}});
}

WebReply StudioApi::save(const std::string& body) {
  const json wanted = parsed(body);
  const bool over = wanted.contains("over") && wanted["over"] == true;
  switch (workspace_.save(version_in(wanted), over)) {
    case SaveResult::saved:
      return json_reply(200, {{"saved", true}});
    case SaveResult::behind:
      return error_reply(409, "the fruit was changed elsewhere in the meantime", "another window has it open");
    case SaveResult::changed_outside:
      break;
  }
  return error_reply(409, "another program has changed the files", "save over them, or go back to them");
}

WebReply StudioApi::revert(const std::string& body) {
  if (workspace_.revert(version_in(parsed(body)))) return document(true);
  return error_reply(409, "the fruit was changed elsewhere in the meantime", "another window has it open");
}

WebReply StudioApi::section(const std::string& body) {
  const json wanted = parsed(body);
  const auto size = static_cast<int>(number_in(wanted, "size", 256, 16, 1024));
  const double height = number_in(wanted, "height", 0.5, 0, 1);
  const std::shared_ptr<const StudioFruit> fruit = fruits_.grown(fruit_in(wanted));
  return {200, std::string(binary), packed(*fruit, section_pictures(*fruit, size, height))};
}

WebReply StudioApi::asset(const std::string& body) {
  const json wanted = parsed(body);
  const std::shared_ptr<const StudioFruit> fruit = fruits_.grown(fruit_in(wanted));
  return {200, std::string(binary), asset_bytes(fruit->source, fruit->order, fruit->wanted.draft)};
}

/// A picture that the drawing links to. It must lie in the drawing's folder or below, and its first bytes must be those
/// of a picture.
WebReply StudioApi::picture(const std::string& href) const {
  const fs::path folder = workspace_.files().toml.parent_path(), file = folder / href;
  std::error_code wrong;
  const bool within = !href.empty() && !fs::path(href).is_absolute() && path_within(folder, file).has_value();
  if (!within || !fs::is_regular_file(file, wrong) || fs::file_size(file, wrong) > max_picture_bytes || wrong)
    return error_reply(404, "there is no such picture beside the template");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.starts_with("\x89PNG\r\n")) return {200, "image/png", std::move(bytes)};
  if (bytes.starts_with("\xff\xd8\xff")) return {200, "image/jpeg", std::move(bytes)};
  return error_reply(404, "there is no such picture beside the template");
}

}  // namespace pomona
