// Lists that ranks put together.
#pragma once

#include <sstream>
#include <vector>

#include "seamount/recipe/value_stream.h"
#include "seamount/tiles/ranks.h"

namespace seamount::tiles {

/// What all ranks have found, in the order of the ranks, everywhere. T: a plain value.
template <class T>
std::vector<T> from_all(Ranks& ranks, const std::vector<T>& mine) {
  const auto bytes = [](const std::vector<T>& list) {
    std::ostringstream text;
    recipe::Writer(text).list(list);
    return text.str();
  };
  const auto list = [](const std::string& text) {
    std::istringstream in(text);
    return recipe::Reader(in).list<T>();
  };
  std::vector<T> all;
  for (const std::string& one : ranks.gather(bytes(mine))) {
    const std::vector<T> more = list(one);
    all.insert(all.end(), more.begin(), more.end());
  }
  return list(ranks.share(bytes(all)));
}

}  // namespace seamount::tiles
