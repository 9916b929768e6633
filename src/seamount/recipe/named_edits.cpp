// Edits by what they mean.
#include "seamount/recipe/edit.h"

namespace seamount::recipe {

Edit set_parameter(const std::string& step, const std::string& parameter, std::optional<OrderedJson> value) {
  return SetValue{"/steps/" + step + "/params/" + parameter, std::move(value)};
}

Edit add_step(OrderedJson step, std::optional<size_t> index) { return InsertItem{"/steps", index, std::move(step)}; }

Edit connect(const std::string& step, const std::string& port, const std::string& source) {
  const auto value = source.empty() ? std::nullopt : std::optional<OrderedJson>(source);
  return SetValue{"/steps/" + step + "/in/" + port, value};
}

Edit connect_file(const std::string& step, const std::string& port, const std::string& file) {
  return SetValue{"/steps/" + step + "/in/" + port, OrderedJson{{"file", file}}};
}

Edit bypass(const std::string& step, bool on) {
  return SetValue{"/steps/" + step + "/bypass", on ? std::optional<OrderedJson>(true) : std::nullopt};
}

Edit set_seed(uint64_t seed) { return SetValue{"/seed", seed}; }

Edit set_domain(const std::string& member, double value) { return SetValue{"/domain/" + member, value}; }

}  // namespace seamount::recipe
