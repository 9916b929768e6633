// The regions that contours grow in: a tree of nested outlines, from whatever its author has.
//
// Source: P2 sec. 3.1 (nesting), 4.5 (several regions, local maxima, basins). A region is the inside of an outline less
// the insides of the outlines in it; the region of a point is the innermost outline that holds it. A basin is a region
// whose inside lies lower than its outline; there is one only where somebody drew it. Where we depart: the paper
// numbers its regions by height; a tree says the same and lets two ranges of different height stand side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// One outline and what lies directly inside it.
struct GrowthRegion {
  std::string name;                ///< never empty: "region 3" where its author gave none
  Ring outline;                    ///< simple, counter-clockwise, without repeated points
  int parent = -1;                 ///< the region around it; -1: the world outside
  std::optional<double> height_m;  ///< of the outline, where known
  bool basin = false;              ///< the ground falls from the outline inwards
  std::optional<double> peak_m;    ///< of the summit, where no hill stands in it; of a basin's deepest place
  bool operator==(const GrowthRegion&) const = default;
};

/// Parents stand before children; outlines neither cross nor touch, so siblings are disjoint; each meets the domain.
/// Heights ascend from a hill's outline to those of the hills in it, and descend from a basin's to those of the basins
/// in it; peaks lie beyond their outlines.
struct RegionTree {
  std::vector<GrowthRegion> regions;
  bool operator==(const RegionTree&) const = default;
};

// Builders. Each throws InvalidArgument{field} in one line that names the regions and a place in metres: no regions, a
// ring of fewer than three points or that is open, one that crosses or touches itself, outlines that overlap without
// nesting or touch, heights in the wrong order, a region wholly outside the domain. About n log n in vertices.

/// From drawn outlines.
RegionTree regions_from_outlines(const std::vector<RegionOutline>& outlines, const GridFrame& domain,
                                 const std::string& field);

/// From the areas and closed lines of a drawing, and what open lines enclose that meet end to end. An area's attributes
/// height_m, peak_m and basin (not 0) are those of its outlines; a hole in an area is a basin. A line's value is its
/// height, unless all are 0; a line that is not higher than the one around it is a basin, as on a map of depression
/// contours.
RegionTree regions_from_drawing(const Drawing& drawing, const GridFrame& domain, const std::string& field);

/// From contours: a clockwise one is a basin. Their levels are all there are, so that a summit or a basin's floor does
/// not reach the next one: peaks go on at the slope around them, up to 85 % of the way there; none at the last levels.
RegionTree regions_from_contours(const ContourSet& set, const GridFrame& domain, const std::string& field,
                                 const RunContext& run = {});

struct PaintedRegions {
  bool darkest_is_land = false;  ///< the darkest level is the lowest region instead of the world outside
};

/// From a picture whose grey levels are nested regions, darker lower, lighter higher, stretched over the domain. Levels
/// are clusters of grey at least 16 apart of 255, found where the picture is flat, so that JPEG noise and soft edges do
/// not matter; a darker patch inside a lighter one is a basin. Land at the picture's edge continues beyond the domain.
/// Outlines lie within two pixels of the painted borders; where several levels meet at one border they fan out by three
/// pixels each. Patches below 12 pixels are noise. A picture whose greys run into each other is cut into up to six
/// zones of equal steps, which is said. Linear in pixels.
RegionTree regions_from_image(const Image& image, const GridFrame& domain, const PaintedRegions& painted,
                              const std::string& field, const RunContext& run);

/// The same for a field, whose lowest and highest values stand for black and white.
RegionTree regions_from_mask(const ScalarField& mask, const GridFrame& domain, const PaintedRegions& painted,
                             const std::string& field, const RunContext& run);

/// Checks outlines in any order and direction and puts them in a tree. `parent` is found, not read. What the builders
/// above end with.
RegionTree nest_regions(std::vector<GrowthRegion> regions, const GridFrame& domain, const std::string& field,
                        const RunContext& run = {});

/// A hill is higher than the hill around it, a basin lower than the basin around it. Ancestors without a height are
/// passed over; where hill and basin alternate any height is possible. Throws InvalidArgument{field}. What
/// nest_regions() holds of each region.
void check_region_height(const std::vector<GrowthRegion>& regions, size_t child, const std::string& field);

/// Index of the region that holds p, -1: none. Brute force, linear in vertices: for tests and single points.
int region_at(const RegionTree& tree, Vec2 p);

/// Region of every point. n log n: outlines are entered into rows of a grid once.
std::vector<int32_t> regions_at(const RegionTree& tree, const std::vector<Vec2>& points, const RunContext& run);

/// The tree in the form in which a network carries it (model/tin.h).
std::vector<TinRegion> tin_regions(const RegionTree& tree);

/// The tree of a network that grew in regions. Throws IncompatibleInputs if it holds no outlines.
RegionTree regions_of(const Tin& tin);

}  // namespace seamount::contour
