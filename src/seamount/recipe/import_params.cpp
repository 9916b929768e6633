#include "seamount/recipe/import_params.h"

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::recipe {

io::ReadOptions read_options(const ImportParams& params, const Call& call, const RunContext& run) {
  if (params.low_m.has_value() != params.high_m.has_value())
    throw InvalidArgument("low_m", "low_m and high_m go together");
  io::ReadOptions options;
  options.cell_m = params.cell_m;
  if (params.low_m) {
    if (*params.low_m >= *params.high_m)
      throw InvalidArgument("low_m", format_number(*params.low_m) + " is not below high_m");
    options.range = io::HeightRange{*params.low_m, *params.high_m};
  }
  if (params.band > 0) options.band = params.band;
  options.coding = params.coding;
  options.unit = params.unit;
  options.crs = params.crs;
  options.byte_order = params.byte_order;
  options.into = call.domain.crs;
  options.run = run;
  return options;
}

}  // namespace seamount::recipe
