// Where new objects of a class begin (P3 sec. 1.5.1): the fitness is asked at many places, and the best of them, or
// some by lot, are taken.
#pragma once

#include <optional>
#include <vector>

#include "seamount/ops/ecosystem/survey.h"

namespace seamount::ecosystem {

/// What asking found: for those who wonder why nothing grows.
struct Prospects {
  size_t asked = 0;
  size_t without_value = 0;       ///< places where the fitness is no number
  std::optional<double> largest;  ///< fitness found, where there was any
  Vec2 where;                     ///< it was found
  std::optional<Vec2> no_number;  ///< a place without a value

  void add(const Prospects& other);
};

struct BirthCall {
  const Scene& scene;
  const Rules& rules;
  const Environment& environment;
  int of_class = 0;
  int window = 0;
  int most = 1;                 ///< places wanted
  const Mask* focus = nullptr;  ///< factor of the fitness (lambda of sec. 1.7.1)
};

/// At most `most` places whose fitness is above the class's threshold of birth, apart by its spacing and within and
/// outside of what it must be; the fittest, or by lot. Jittered samples, one a square, over the frame or over the
/// regions that it lives within. Depends on the scene's seed, its iteration, class and window alone. Linear in the
/// samples.
std::vector<Vec2> birth_places(const BirthCall& call, Prospects& prospects, const RunContext& run);

/// Is a place within one of the regions, and outside all of those, that the class asks for?
std::vector<bool> allowed_places(const Rules& rules, const Environment& environment, int of_class,
                                 std::span<const Vec2> places, const RunContext& run);

}  // namespace seamount::ecosystem
