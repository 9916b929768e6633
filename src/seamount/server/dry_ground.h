// Which low ground is no sea, as the page draws it: computed once for each terrain that is shown.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "seamount/recipe/value.h"
#include "seamount/server/value_bytes.h"

namespace seamount::server {

/// Hollows (geom/water/inland.h) of the terrains that were asked for last: at most kKept of them, a byte a cell of
/// those that have any. For any thread.
class DryGround {
 public:
  static constexpr size_t kKept = 4;

  /// The window of dry ground as a byte a cell: 255 on ground below 0 m that is no sea and on land that touches it, so
  /// that its shore is where heights say, at any level; 0 elsewhere. At level 0 it is render::dry_below_sea(). Nothing
  /// where the whole terrain has none, or the value is no terrain. `key`: of the value. Errors: of raster_bytes().
  /// Cost: the first time of find_hollows(), then linear in the window.
  std::optional<std::string> bytes(const std::string& key, const recipe::Value& value, const RasterWindow& window);

 private:
  using Hollows = std::shared_ptr<const Grid<uint8_t>>;

  Hollows hollows_of(const std::string& key, const HeightField& terrain);

  std::mutex mutex_;
  std::deque<std::pair<std::string, Hollows>> kept_;  ///< the newest last
};

}  // namespace seamount::server
