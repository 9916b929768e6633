// Making an output format of a field table and a function.
#pragma once

#include <tuple>
#include <utility>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// For formats without parameters.
struct NoParams {
  static constexpr auto fields() { return std::tuple(); }
};

/// `row` with its parameters and its writer, write(const Params&, const OutputCall&), filled in.
template <class Params, class Function>
OutputFormat make_format(OutputFormat row, Function write) {
  row.params = describe_params<Params>();
  row.complete = [](const Json& given, const ReadPlace& place) {
    return write_params(read_params<Params>(given, place));
  };
  row.write = [write](const Json& complete_params, const OutputCall& call) {
    Diagnostics diagnostics;
    const auto params = read_params<Params>(complete_params, {"", diagnostics});
    if (!diagnostics.empty()) throw RecipeError(call.path, diagnostics.items());
    write(params, call);
  };
  return row;
}

}  // namespace seamount::recipe
