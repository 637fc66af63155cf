#include "cli/diffusers.h"

#include <map>
#include <string>
#include <utility>

#include "generator/base/error.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/diffusion/walk/walk_diffuser.h"
#include "render/diffusion/gl_diffuser.h"

namespace pomona {

namespace {

/// The option has been checked.
Quality quality_of(const SharedOptions& options) { return quality_named(options.quality).value(); }

using Maker = std::unique_ptr<Diffuser> (*)(const SharedOptions& options);

std::unique_ptr<Diffuser> on_processor(const SharedOptions& options) {
  return make_pmvc_diffuser({.quality = quality_of(options), .threads = {options.threads}});
}

GlDiffuserOptions by_opengl(const SharedOptions& options) {
  return {.quality = quality_of(options), .threads = {options.threads}};
}

std::unique_ptr<Diffuser> on_opengl(const SharedOptions& options) { return make_gl_diffuser(by_opengl(options)); }

/// OpenGL in software is no gain.
std::unique_ptr<Diffuser> on_card_or_processor(const SharedOptions& options) {
  std::unique_ptr<Diffuser> on_card = make_diffuser_on_graphics_card(by_opengl(options));
  return on_card != nullptr ? std::move(on_card) : on_processor(options);
}

std::unique_ptr<Diffuser> on_grid(const SharedOptions& options) {
  return make_harmonic_diffuser({.quality = quality_of(options), .threads = {options.threads}});
}

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> all = {
      {"auto", on_card_or_processor},
      {"cpu", on_processor},
      {"gl", on_opengl},
      {"harmonic", on_grid},
  };
  return all;
}

/// The only one that takes long enough to show how far it is.
std::unique_ptr<Diffuser> by_walks(const SharedOptions& options, Progress& progress) {
  WalkOptions walk;
  walk.standard_error = standard_error_of(quality_of(options));
  walk.threads = {options.threads};
  walk.progress = [&progress](std::size_t done, std::size_t total) { progress.report("diffuse", done, total); };
  return make_walk_diffuser(walk);
}

}  // namespace

std::unique_ptr<Diffuser> make_diffuser(const SharedOptions& options, Progress& progress) {
  if (options.diffuser == "walk") return by_walks(options, progress);
  const auto maker = makers().find(options.diffuser);
  if (maker == makers().end()) {
    throw Error(ExitStatus::usage, "--diffuser " + options.diffuser + ": this version does not have it",
                "use --diffuser cpu");
  }
  return maker->second(options);
}

}  // namespace pomona
