// The kinds of values that Seamount knows. Each is a file of kinds/ that says everything about it; here it only has its
// C++ type, so that operators can be registered with typed ports (ports.h).
#pragma once

#include <tuple>

#include "seamount/model/areas.h"
#include "seamount/model/catalogue.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/report.h"
#include "seamount/model/scene.h"
#include "seamount/model/things.h"
#include "seamount/model/tin.h"
#include "seamount/model/vector_field.h"
#include "seamount/recipe/kind.h"

namespace seamount::recipe {

class Registry;

namespace kinds {

// `Type` is what the values hold, kind() all about them, add_formats() registers the files that they are written to.
// terrain and field are both rasters of float and differ in what they may be connected to.
// clang-format off
struct Terrain  { using Type = HeightField;       static const Kind& kind(); static void add_formats(Registry&); };
struct Labels   { using Type = LabelMap;          static const Kind& kind(); static void add_formats(Registry&); };
struct Field    { using Type = ScalarField;       static const Kind& kind(); static void add_formats(Registry&); };
struct Current  { using Type = VectorField;       static const Kind& kind(); static void add_formats(Registry&); };
struct Image    { using Type = seamount::Image;   static const Kind& kind(); static void add_formats(Registry&); };
struct Drawing  { using Type = seamount::Drawing; static const Kind& kind(); static void add_formats(Registry&); };
struct Tin      { using Type = seamount::Tin;     static const Kind& kind(); static void add_formats(Registry&); };
struct Contours { using Type = ContourSet;        static const Kind& kind(); static void add_formats(Registry&); };
struct Report   { using Type = seamount::Report;  static const Kind& kind(); static void add_formats(Registry&); };
struct Things   { using Type = seamount::Things;  static const Kind& kind(); static void add_formats(Registry&); };
struct Catalogue { using Type = seamount::Catalogue; static const Kind& kind(); static void add_formats(Registry&); };
struct Objects  { using Type = Scene;             static const Kind& kind(); static void add_formats(Registry&); };
// clang-format on

// Asked in this order what a file is: those that know theirs by what it holds come before drawings, which take any.
using All =
    std::tuple<Terrain, Labels, Field, Current, Image, Things, Catalogue, Objects, Drawing, Tin, Contours, Report>;

}  // namespace kinds
}  // namespace seamount::recipe
