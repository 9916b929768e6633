// What the engine shows: results of a revision, at a quality.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seamount/recipe/engine.h"
#include "seamount/recipe/plan.h"

namespace seamount::recipe {

/// The results of one revision at one quality that somebody wants to see.
struct View {
  uint64_t revision = 0;
  bool coarse = false;
  std::string gesture;               ///< of the edit that led to the revision
  std::map<Source, Source> sources;  ///< what is wanted, and where it really comes from
  std::shared_ptr<const Plan> plan;
};

/// The newest result of something wanted.
struct Latest {
  Finished finished;
  Digest key;

  /// Is a view's result newer or better, or another one since a file has changed?
  bool gives_way_to(const View& view, const Digest& other) const {
    const std::pair mine(finished.revision, !finished.coarse), theirs(view.revision, !view.coarse);
    return theirs > mine || (theirs == mine && !(other == key));
  }
};

/// Those of the wanted sources that a recipe has, by what was asked for, and where they really come from: a bypassed
/// step passes on another's.
std::map<Source, Source> find_sources(const Recipe& recipe, const std::vector<Source>& wanted);

}  // namespace seamount::recipe
