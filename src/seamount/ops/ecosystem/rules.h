// A catalogue made ready for work: every name an index, every expression compiled; and all that is wrong with one.
//
// Words of expressions, at a place:
//   height, depth        metres over and under the water level          ground        metres over z = 0
//   slope_deg            of the ground                                  gradient_x, gradient_y    rise over run
//   current              speed of the water, m/s                        current_x, current_y      its components
//   x, y                 metres                                         age           iterations since birth; 0 unborn
//   iteration            of the scene or the window                     water_level   metres over z = 0
//   NAME                 concentration of the material of that name
//   distance(CLASS)      metres to the nearest object of a class, outside of itself; 0 within a region; the diagonal of
//                        the frame where there is none
//   border(CLASS)        the same, but to the outline within regions as well
//   inside(CLASS)        1 within a region of the class, else 0
//   normal_x(CLASS), normal_y(CLASS)   unit vector from the nearest one to the place; 0 where there is none
//   curvature(CLASS)     1/m, of the nearest curve or outline at its nearest point; above 0 where a region bulges
//   screened(CLASS)      distance as a field that spreads from the class and decays tells it (eq. 1.39): smooth where
//   the
//                        exact one has creases, itself included, 40 ms a class; larger beside single points
//   noise(METRES)        gradient noise of that wavelength, about -1 to 1, of the scene's seed
// An object never finds itself.
#pragma once

#include <string>
#include <vector>

#include "seamount/geom/scalar/expression.h"
#include "seamount/model/catalogue.h"

namespace seamount::ecosystem {

/// Something wrong in a catalogue, with its place as a JSON pointer: "/classes/2/fitness".
struct CatalogueDefect {
  std::string pointer;
  std::string message;
};

struct ClassRules {
  geom::Expression fitness;
  geom::Expression fitting;
  std::vector<int> within, outside;    ///< indices of classes
  std::vector<int> deposits, absorbs;  ///< of materials, as in the class
};

struct Rules {
  std::vector<ClassRules> classes;
  std::vector<int> material_order;         ///< those that others turn into come after those
  std::vector<bool> screened;              ///< by class: does an expression ask for screened(CLASS)?
  std::vector<std::pair<int, int>> turns;  ///< from and to of the transformations
};

/// All defects of a catalogue: names that are no names, given twice, or taken by a word of expressions; expressions
/// that do not parse ("column 9: unknown name ..."); names of materials and classes that there are not; shapes of
/// heights that do not fit the skeleton; thresholds, cells and places that leave no life; materials that turn into
/// themselves by a ring, classes that only live within one another. Empty: it can be used.
std::vector<CatalogueDefect> find_defects(const Catalogue& catalogue);

/// Throws InvalidArgument with the first defect. Linear in the catalogue's text.
Rules compile(const Catalogue& catalogue);

/// Marks the classes whose screened distance an expression asks for.
void mark_screened(const Catalogue& catalogue, const geom::Expression& expression, Rules& rules);

/// Index of a class. Throws InvalidArgument{place} for a name that none has, with the nearest one.
size_t class_named(const Catalogue& catalogue, const std::string& name, const std::string& place);

/// What an expression over this catalogue may speak of.
geom::Vocabulary vocabulary_of(const Catalogue& catalogue);

}  // namespace seamount::ecosystem
