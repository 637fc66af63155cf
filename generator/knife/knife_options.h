// The options that may follow a knife's size: "at=0,4cm,3cm,depth=2cm".
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A knife is not valid. what() is the end of a sentence that begins with the knife. If the hint is empty, the list of
/// all knives is shown.
struct BadKnife : std::runtime_error {
  explicit BadKnife(const std::string& why, std::string hint_in = {})
      : std::runtime_error(why), hint(std::move(hint_in)) {}
  std::string hint;
};

/// "1,2,,3" has four parts, one of them empty; "" has one.
std::vector<std::string_view> split_at_commas(std::string_view text);

/// Options by name. The value of an option goes on to the next name, so it may be a list.
class KnifeOptions {
 public:
  /// `words` must outlive the object; `known` are the options there are, as a user would write them: "depth=4cm".
  /// \throws BadKnife for words that belong to no option, and names that are not known or are said twice.
  KnifeOptions(std::span<const std::string_view> words, std::span<const std::string> known);

  /// A length above 0 and at most `max` metres, if the option is there. \throws BadKnife for any other value.
  std::optional<double> length(std::string_view name, double max) const;

  /// 0, 1 or 2 for x, y or z. \throws BadKnife for any other value.
  std::optional<int> axis(std::string_view name) const;

  /// Three lengths, each within 100 m. \throws BadKnife
  std::optional<glm::dvec3> place(std::string_view name) const;

  /// Three numbers, made to a unit vector. \throws BadKnife
  std::optional<glm::dvec3> direction(std::string_view name) const;

 private:
  struct Option {
    std::string_view name;
    std::vector<std::string_view> values;
  };

  const Option* find(std::string_view name) const;
  template <typename Parse>
  std::optional<glm::dvec3> triple(std::string_view name, const Parse& parse, const std::string& example) const;
  void check(std::span<const std::string> known) const;

  std::vector<Option> options_;
};

}  // namespace pomona
