// Kinds of values, operators and output formats by name. One registration (operators/*.cpp, kinds/*.cpp, formats/*.cpp)
// gives an operator its command, recipe step, schema, reference page, cache entry and contract test.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/model/reach.h"
#include "seamount/recipe/param_json.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// How an input that lies somewhere meets the first raster among the inputs, or the document's domain.
enum class Placing {
  cells,     ///< rasters come onto its very cells, anything else into its system
  system,    ///< all come into its system and keep their own cells
  anywhere,  ///< it may lie where it will: only its values count
};

/// A named input or output of an operator. Made by ports.h.
struct Port {
  std::string name;
  const Kind* kind = nullptr;
  std::string help;
  bool required = true;  ///< inputs only: optional inputs may be left open
  std::string former;    ///< a name that it had in earlier versions, still read with a note
  Placing placing = Placing::cells;
  bool voids = false;  ///< the operator respects cells without a value (NaN); else they are filled before it runs
};

/// What a running operator is given besides its inputs and parameters.
struct Call {
  const GridFrame& domain;    ///< the document's frame, for operators that make a raster from nothing; one that states
                              ///< no system lies where the inputs do
  bool domain_stated;         ///< false: the document says nothing of its size
  Seed seed;                  ///< for stochastic operators
  const std::string& folder;  ///< relative file names are relative to it
  const RunContext& run;
  const GridFrame* whole = nullptr;  ///< of what is run window by window: the frame of all of it

  /// A file parameter as a path that can be opened.
  std::string resolve(const FilePath& file) const;
  std::string resolve(const ModelFile& model) const;
};

/// One operator.
struct Operator {
  std::string name;     ///< "island.coral": the contract
  int revision = 1;     ///< raised when the same inputs give another result; part of the cache key
  std::string summary;  ///< one line: what it makes
  std::string source;   ///< paper and section
  bool stochastic = false;
  bool cached = true;         ///< false: made faster than read back
  bool needs_one = false;     ///< one of its inputs is needed, whichever, though none is required alone
  std::string looks = {};     ///< how far a cell looks, for people; empty: at everything
  std::string in_tiles = {};  ///< how worlds that do not fit into memory have it all the same; empty: as `looks` says

  // Filled in by Registry::add from the typed ports and the field table.
  std::vector<Port> in;
  std::vector<Port> out;
  std::vector<ParamInfo> params;
  std::vector<FormerParam> former;                                    ///< former names of params
  std::function<Json(const Json& given, const ReadPlace&)> complete;  ///< checks, fills in defaults
  std::function<Values(const Json& complete_params, const Values& in, const Call&)> run;
  /// How far a cell of the outputs looks on rasters whose cells are the first one's (Placing::cells), or on nothing, in
  /// the domain's cells; what else is put in is always looked at as a whole. Empty: everything.
  std::function<Reach(const Json& complete_params, double cell_m)> reach;
  /// The parameters with which it looks no further than that, once the lowest and the highest cell of its first raster
  /// are known. Empty: there are none.
  std::function<Json(const Json& complete_params, float lowest, float highest)> settled = {};

  const Port* find_in(std::string_view port) const;
  const Port* find_out(std::string_view port) const;
};

/// What a writer is told besides its parameters.
struct OutputCall {
  const Value& value;      ///< what to write, or what an operator made of it (OutputFormat::prepare)
  const Values& prepared;  ///< results of the other operators that prepare() named
  std::string path;        ///< where to write, with folder
  io::Provenance provenance;
  const RunContext& run;
};

/// A raster to write that need not be in memory as a whole.
struct WindowedCall {
  const Kind& kind;
  const GridFrame& frame;
  std::function<Value(int column, int row, int width, int height)> window;  ///< so many of its cells
  const Values& prepared;
  std::string path;
  io::Provenance provenance;
  const RunContext& run;
};

/// An operator that runs before an output is written, like any step of the recipe: its inputs "terrain", "contours" ...
/// are the value that is written, "labels" what goes with it.
struct Preparation {
  std::string name;  ///< for the writer; empty: the result is written in the value's place
  std::string op;
  std::string port;  ///< the output that is wanted
  Json params;
};

/// A way to write a value, by name ("as") or by file extension.
struct OutputFormat {
  std::string name;                     ///< "as" in a recipe
  std::string summary;                  ///< one line
  std::vector<std::string> extensions;  ///< ".tif": the file names it can write; the first is the default
  std::vector<std::string> claims;      ///< extensions for which it is chosen when "as" is absent
  std::vector<const Kind*> accepts;

  // Filled in from the field table by make_format().
  std::vector<ParamInfo> params;
  std::function<Json(const Json& given, const ReadPlace&)> complete;
  std::function<void(const Json& complete_params, const OutputCall&)> write;

  /// Writes a raster window by window, the same files as write(); false: this one must be there as a whole. Empty: the
  /// format has no such way.
  std::function<bool(const Json& complete_params, const WindowedCall&)> write_windows;

  /// What must be made of a value before it can be written; empty: nothing. Throws InvalidArgument{"path"} or another
  /// field of the output for what cannot be written so.
  std::function<std::vector<Preparation>(const Json& complete_params, const Kind& kind, const std::string& path)>
      prepare;
  /// Names of all files that a value is written to; '*' stands for digits. Empty: the path alone.
  std::function<std::vector<std::string>(const Json& complete_params, const Kind& kind, const std::string& path)> files;

  bool takes(const Kind& kind) const;
};

class Registry {
 public:
  /// A kind, and the formats that it is written to.
  template <class K>
  void add_kind() {
    kinds_.push_back(&K::kind());
    K::add_formats(*this);
  }
  void add(Operator op) { operators_.push_back(std::make_shared<const Operator>(std::move(op))); }
  void add(OutputFormat format) { formats_.push_back(std::make_shared<const OutputFormat>(std::move(format))); }

  // Pointers stay valid as long as a copy of the registry that they were found in.
  const std::vector<const Kind*>& kinds() const { return kinds_; }
  const std::vector<std::shared_ptr<const Operator>>& operators() const { return operators_; }
  const std::vector<std::shared_ptr<const OutputFormat>>& formats() const { return formats_; }

  const Kind* find_kind(std::string_view name) const;
  const Operator* find_operator(std::string_view name) const;
  const OutputFormat* find_format(std::string_view name) const;
  /// The format that a file name asks for by its extension, for a value of this kind; nullptr if there is none.
  const OutputFormat* format_for(const std::string& path, const Kind& kind) const;

  std::vector<std::string> operator_names() const;

 private:
  std::vector<const Kind*> kinds_;
  std::vector<std::shared_ptr<const Operator>> operators_;
  std::vector<std::shared_ptr<const OutputFormat>> formats_;
};

/// Everything that Seamount has: operators in the order of families. Built on first use. A program with kinds or
/// operators of its own copies it, adds to the copy and hands that to parse_recipe().
const Registry& standard_registry();

// One function per family, each in operators/<family>.cpp; contours out of terrains and back stand apart.
void add_terrain_operators(Registry& registry);
void add_island_operators(Registry& registry);
void add_contour_operators(Registry& registry);
void add_contour_conversions(Registry& registry);
void add_reef_operators(Registry& registry);
void add_hydrology_operators(Registry& registry);
void add_erosion_operators(Registry& registry);
void add_glacier_operators(Registry& registry);
void add_sketch_operators(Registry& registry);
void add_learned_operators(Registry& registry);
void add_classify_operators(Registry& registry);
void add_thing_operators(Registry& registry);
void add_render_operators(Registry& registry);
void add_ecosystem_operators(Registry& registry);
void add_amplify_operators(Registry& registry);

}  // namespace seamount::recipe
