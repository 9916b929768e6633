// Asks expressions at places of an environment, many at once.
#pragma once

#include <cstdint>
#include <span>

#include "seamount/geom/scalar/expression.h"
#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// Places, and on whose behalf they are asked.
struct Places {
  std::span<const Vec2> at;
  std::span<const int32_t> self = {};  ///< index of the object that asks, -1 for none; one for all, or empty: nobody
  std::span<const double> age = {};    ///< iterations since birth; empty: 0
};

class Survey {
 public:
  /// All must outlive it.
  Survey(const Scene& scene, const Environment& environment, const RunContext& run)
      : scene_(scene), environment_(environment), run_(run) {}

  /// out[i] at place i; NaN outside the environment's frame. Fields are read bilinearly, objects exactly. Parallel;
  /// about 50 ns a place and word.
  void ask(const geom::Expression& expression, const Places& places, std::span<double> out) const;

 private:
  void ask_block(const geom::Expression& expression, const Places& places, std::span<double> out) const;

  const Scene& scene_;
  const Environment& environment_;
  const RunContext& run_;
};

}  // namespace seamount::ecosystem
