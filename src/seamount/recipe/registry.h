// Operators by name. One registration (recipe/operators/*.cpp) gives an operator its command, recipe step, schema,
// reference page, cache entry and contract test.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/recipe/param_json.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// A named input or output of an operator.
struct Port {
  std::string name;
  ValueKind kind;
  std::string help;
  bool required = true;  ///< inputs only: optional inputs may be left open
};

/// Names of ports of one kind: "terrain", "terrain_2", "terrain_3".
std::string numbered(const std::string& name, int i);

/// What a running operator is given besides its parameters.
struct Call {
  const GridFrame& domain;    ///< the document's frame, for operators that make a raster from nothing
  Seed seed;                  ///< for stochastic operators
  const Values& in;           ///< connected inputs by port name
  const std::string& folder;  ///< relative file names are relative to it
  const RunContext& run;

  /// The input, or nullptr where an optional one is open.
  const Value* input(std::string_view port) const {
    const auto found = in.find(port);
    return found == in.end() ? nullptr : &found->second;
  }
  const LabelMap* labels(std::string_view port) const {
    const Value* value = input(port);
    return value == nullptr ? nullptr : &value->regions();
  }
  const Drawing* shapes(std::string_view port) const {
    const Value* value = input(port);
    return value == nullptr ? nullptr : &value->shapes();
  }
  const ScalarField* scalars(std::string_view port) const {
    const Value* value = input(port);
    return value == nullptr ? nullptr : &value->scalars();
  }
  /// A file parameter as a path that can be opened.
  std::string resolve(const FilePath& file) const;
};

/// One row of the registry.
struct Operator {
  std::string name;     ///< "island.coral": the contract
  int revision = 1;     ///< raised when the same inputs give another result; part of the cache key
  std::string summary;  ///< one line: what it makes
  std::string source;   ///< paper and section
  bool stochastic = false;
  std::vector<Port> in;
  std::vector<Port> out;

  // Filled in from the field table by Registry::add.
  std::vector<ParamInfo> params;
  std::function<Json(const Json& given, const ReadPlace&)> complete;  ///< checks, fills in defaults
  std::function<Values(const Json& complete_params, const Call&)> run;

  const Port* find_in(std::string_view port) const;
  const Port* find_out(std::string_view port) const;
};

class Registry {
 public:
  template <class Params, class Function>
  void add(Operator op, Function function) {
    op.params = describe_params<Params>();
    op.complete = [](const Json& given, const ReadPlace& place) {
      return write_params(read_params<Params>(given, place));
    };
    op.run = [function](const Json& complete_params, const Call& call) {
      Diagnostics diagnostics;
      const auto params = read_params<Params>(complete_params, {"", diagnostics});
      if (!diagnostics.empty()) throw RecipeError("parameters", diagnostics.items());
      return function(params, call);
    };
    operators_.push_back(std::move(op));
  }

  const std::vector<Operator>& all() const { return operators_; }
  const Operator* find(std::string_view name) const;
  std::vector<std::string> names() const;

 private:
  std::vector<Operator> operators_;
};

/// Every operator of Seamount, in the order of families. Built on first use.
const Registry& operators();

// One function per family, each in operators/<family>.cpp; contours out of terrains and back stand apart.
void add_terrain_operators(Registry& registry);
void add_island_operators(Registry& registry);
void add_contour_operators(Registry& registry);
void add_contour_conversions(Registry& registry);
void add_reef_operators(Registry& registry);
void add_hydrology_operators(Registry& registry);
void add_erosion_operators(Registry& registry);
void add_sketch_operators(Registry& registry);
void add_classify_operators(Registry& registry);
void add_render_operators(Registry& registry);

}  // namespace seamount::recipe
