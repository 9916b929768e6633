// What a recipe can write: output formats by name ("as") or by file extension, each with its own field table.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/recipe/param_json.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// What a writer is told besides the value and its parameters.
struct OutputCall {
  const Value& value;
  const LabelMap* labels = nullptr;  ///< regions that go with a terrain, if there are any
  std::string path;                  ///< where to write, with folder
  io::Provenance provenance;         ///< for side-cars and metadata
  const RunContext& run;
};

struct OutputFormat {
  std::string name;                     ///< "as" in a recipe
  std::string summary;                  ///< one line
  std::vector<std::string> extensions;  ///< ".tif": the file names it can write; the first is the default
  std::vector<std::string> claims;      ///< extensions for which it is chosen when "as" is absent
  std::vector<ValueKind> accepts;

  // Filled in from the field table.
  std::vector<ParamInfo> params;
  std::function<Json(const Json& given, const ReadPlace&)> complete;
  std::function<void(const Json& complete_params, const OutputCall&)> write;

  bool takes(ValueKind kind) const;
};

/// Every output format. Built on first use.
const std::vector<OutputFormat>& output_formats();

const OutputFormat* find_output_format(std::string_view name);

/// The format that a file name asks for by its extension, for a value of this kind; nullptr if there is none.
const OutputFormat* output_format_for(const std::string& path, ValueKind kind);

}  // namespace seamount::recipe
