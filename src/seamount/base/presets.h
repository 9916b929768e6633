// Presets: values of a Params struct that belong together, under a word. They stand beside its fields() and are written
// with its own members, so that a wrong name or type does not compile:
//
//   static constexpr auto presets() {
//     using P = RunParams;
//     return std::array{preset<P>("desert", "bare cliffs over aprons of debris", [](P& p) { p.runoff_mm_yr = 80; })};
//   }
//
// A document chooses one by "preset": "desert" among the parameters, and what it states besides wins over the preset's
// values. Nothing but these values goes on from there: who runs an operator knows no presets.
#pragma once

#include <concepts>
#include <string_view>

#include "seamount/base/fields.h"

namespace seamount {

/// One word and what it sets; what it leaves alone keeps its default.
template <class Params>
struct Preset {
  std::string_view name;
  std::string_view about;  ///< one line on what it looks like, no full stop
  void (*set)(Params& params);
};

template <class Params>
constexpr Preset<Params> preset(std::string_view name, std::string_view about, void (*set)(Params& params)) {
  return {name, about, set};
}

/// The name under which a preset is chosen, which no parameter may have.
inline constexpr std::string_view kPresetKey = "preset";

/// A struct with presets.
template <class T>
concept HasPresets = HasFields<T> && requires {
  { T::presets()[0] } -> std::convertible_to<Preset<T>>;
};

}  // namespace seamount
