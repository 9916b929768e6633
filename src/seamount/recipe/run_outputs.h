// Writing the outputs of a run: all of them appear together, or none.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

struct OutputReport {
  std::string path;  ///< as opened: output folder and relative path; of formats of many files the first of them
  std::string format;
  double seconds = 0.0;
  std::vector<std::string> files = {};  ///< all that were written, side-cars too, in the order of OutputFormat::files
  std::vector<std::string> notes = {};  ///< what the writer said
};

/// Writes an output to `path` in a way of its own; false: the output's format shall write it.
using RowsWriter = std::function<bool(const Output& output, const std::string& path, const io::Provenance& provenance,
                                      const RunContext& run)>;

/// What the files of a recipe's outputs say made them.
io::Provenance provenance_of(const Recipe& recipe);

/// Writes all outputs side by side below a private folder in `out_folder` and moves them into place at the end. `value`
/// gives the value of a source; `part` the context of output i, for its progress. Throws what writers throw, with
/// "output 'x': " before it and final file names in it; then nothing has changed. What they say is passed on with the
/// same before it. `by_rows` is asked first for every output whose value shall not be fetched; empty: for none.
std::vector<OutputReport> write_outputs(const Recipe& recipe, const std::string& out_folder,
                                        const std::function<const Value&(const Source&)>& value,
                                        const std::function<RunContext(size_t)>& part, const RunContext& run,
                                        const RowsWriter& by_rows = {});

}  // namespace seamount::recipe
