#include "cli/studio/workspace.h"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/path_within.h"
#include "generator/text/toml_node.h"
#include "render/export/output.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::uintmax_t max_text_bytes = std::uintmax_t{24} << 20;  // of a template or a sketch
// Two texts, each twice, and twice that for characters that JSON escapes.
constexpr std::uintmax_t max_unsaved_bytes = 8 * max_text_bytes;

void check_size(const fs::path& file, std::uintmax_t bytes, std::uintmax_t max) {
  if (bytes <= max) return;
  throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, {}},
                                      "is larger than the studio holds, " + std::to_string(max >> 20) + " MiB",
                                      "link the picture instead of embedding it"}});
}

std::string kept_text(const fs::path& file, std::uintmax_t max = max_text_bytes) {
  std::error_code wrong;
  check_size(file, fs::is_regular_file(file, wrong) ? fs::file_size(file, wrong) : 0, max);
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) throw Error(ExitStatus::input_missing, file.string() + " cannot be read");
  return text;
}

}  // namespace

WorkspaceFiles workspace_files(const fs::path& toml, const std::string& text) {
  WorkspaceFiles files{toml, {}, toml.string() + ".unsaved"};
  std::string sketch;
  try {
    const TomlNode root = parse_toml(text, toml.string());
    for (const TomlEntry& entry : root.entries) {
      if (entry.key == "sketch" && entry.value.kind == TomlNode::Kind::string) sketch = entry.value.text;
    }
  } catch (const Error&) {
    // A template that is no valid TOML is opened so that it can be corrected; its sketch probably has the same name.
    const fs::path likely = fs::path(toml).replace_extension(".svg");
    if (fs::exists(likely)) sketch = likely.filename().string();
  }
  if (sketch.empty()) return files;
  files.svg = toml.parent_path() / sketch;
  if (fs::path(sketch).is_absolute() || !path_within(toml.parent_path(), files.svg)) {
    throw Error(ExitStatus::bad_data, {{{toml.string(), 0, 0, {}},
                                        "its sketch \"" + sketch.substr(0, 200) + "\" leads out of its folder",
                                        "put the SVG beside the template"}});
  }
  return files;
}

Workspace::Workspace(WorkspaceFiles files, std::optional<FruitTexts> starting) : files_(std::move(files)) {
  exists_ = !starting;
  if (!starting && !fs::is_regular_file(files_.toml))
    throw Error(ExitStatus::input_missing, files_.toml.string() + " cannot be read");
  if (exists_) saved_ = on_disk();
  state_.texts = starting ? std::move(*starting) : saved_;
  state_.unsaved = !exists_;
  recover();
}

FruitTexts Workspace::on_disk() const {
  return {kept_text(files_.toml), files_.svg.empty() ? "" : kept_text(files_.svg)};
}

/// Reads the unsaved edits of a studio that was killed. A file of another kind is not touched; the next edit's save
/// tells of it.
void Workspace::recover() {
  std::error_code ignored;
  if (!fs::is_regular_file(files_.unsaved, ignored)) return;
  const auto json = nlohmann::json::parse(kept_text(files_.unsaved, max_unsaved_bytes), nullptr, false);
  const auto is_text = [&](const char* key) { return json.contains(key) && json[key].is_string(); };
  if (!json.is_object() || !is_text("toml") || !is_text("svg") || !is_text("toml_was") || !is_text("svg_was")) return;
  const FruitTexts texts{json["toml"], json["svg"]}, before{json["toml_was"], json["svg_was"]};
  if (texts == saved_) return forget_unsaved();
  state_.changed_outside = exists_ && before != saved_;
  state_.texts = texts;
  state_.unsaved = state_.recovered = true;
}

void Workspace::keep_unsaved() const {
  const nlohmann::ordered_json json = {
      {"note", "edits of `pomona studio` that are not saved yet; it takes them up again"},
      {"toml", state_.texts.toml},
      {"svg", state_.texts.svg},
      {"toml_was", saved_.toml},
      {"svg_was", saved_.svg}};
  write_whole(files_.unsaved, json_text(json));
}

void Workspace::forget_unsaved() const {
  std::error_code ignored;
  fs::remove(files_.unsaved, ignored);
}

/// Reads the files again, if the texts are not edited.
void Workspace::take_in() {
  std::error_code ignored;
  if (!fs::is_regular_file(files_.toml, ignored)) return;
  const FruitTexts now = on_disk();
  if (exists_ && now == saved_) return;
  if (now == state_.texts) {
    state_.unsaved = state_.recovered = state_.changed_outside = false;
    forget_unsaved();
  } else if (state_.unsaved) {
    state_.changed_outside = true;
    return;
  } else {
    state_.texts = now;
    ++state_.version;
  }
  saved_ = now;
  exists_ = true;
}

WorkspaceState Workspace::state() {
  const std::lock_guard lock(mutex_);
  take_in();
  return state_;
}

std::optional<std::uint64_t> Workspace::change(std::uint64_t seen, FruitTexts texts) {
  const std::lock_guard lock(mutex_);
  if (seen != state_.version) return {};
  if (texts == state_.texts) return state_.version;
  // An edit that the studio could not open again is refused.
  check_size(files_.toml, texts.toml.size(), max_text_bytes);
  check_size(files_.svg, texts.svg.size(), max_text_bytes);
  const WorkspaceState before = state_;
  state_.texts = std::move(texts);
  state_.unsaved = !exists_ || state_.texts != saved_;
  try {
    if (state_.unsaved) keep_unsaved();
  } catch (...) {
    state_ = before;
    throw;
  }
  if (!state_.unsaved) forget_unsaved();
  return ++state_.version;
}

SaveResult Workspace::save(std::uint64_t seen, bool over) {
  const std::lock_guard lock(mutex_);
  if (seen != state_.version) return SaveResult::behind;
  take_in();
  if (seen != state_.version) return SaveResult::behind;
  if (state_.changed_outside && !over) return SaveResult::changed_outside;
  std::vector<OutputFile> outputs = {{files_.toml, state_.texts.toml}};
  if (!files_.svg.empty()) outputs.push_back({files_.svg, state_.texts.svg});
  write_whole(outputs);
  saved_ = state_.texts;
  exists_ = true;
  state_.unsaved = state_.recovered = state_.changed_outside = false;
  forget_unsaved();
  return SaveResult::saved;
}

bool Workspace::revert(std::uint64_t seen) {
  const std::lock_guard lock(mutex_);
  if (seen != state_.version) return false;
  if (!exists_) return true;
  saved_ = state_.texts = on_disk();
  state_.unsaved = state_.recovered = state_.changed_outside = false;
  forget_unsaved();
  ++state_.version;
  return true;
}

}  // namespace pomona
