// Registration of what leads from terrains to contours and back.
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

/// The one input of two that is connected.
const Value& one_of(const Call& call, std::string_view first, std::string_view second) {
  const Value* a = call.input(first);
  const Value* b = call.input(second);
  if ((a == nullptr) == (b == nullptr))
    throw IncompatibleInputs("connect either '" + std::string(first) + "' or '" + std::string(second) + "'" +
                             (a == nullptr ? "; neither is" : ", not both"));
  return a != nullptr ? *a : *b;
}

Values extract(const contour::ExtractParams& params, const Call& call) {
  const Value& from = one_of(call, "tin", "terrain");
  return {{"contours",
           Value::contours(from.kind() == ValueKind::tin ? contour::extract(from.network(), params, call.run)
                                                         : contour::extract(from.heights(), params, call.run))}};
}

Values reconstruct(const contour::ReconstructParams& params, const Call& call) {
  const Value& from = one_of(call, "contours", "tin");
  return {{"terrain",
           Value::terrain(from.kind() == ValueKind::tin ? contour::reconstruct(from.network(), params, call.run)
                                                        : contour::reconstruct(from.contour_set(), params, call.run))}};
}

}  // namespace

void add_contour_conversions(Registry& registry) {
  registry.add<contour::ExtractParams>({.name = "contour.extract",
                                        .summary = "The contours of a network or of a terrain, closed and nested",
                                        .source = "P2 sec. 4.4",
                                        .in = {{"tin", ValueKind::tin, "a network with heights", false},
                                               {"terrain", ValueKind::terrain, "or heights in metres", false}},
                                        .out = {{"contours", ValueKind::contours, "nested closed contours"}}},
                                       extract);
  registry.add<contour::ReconstructParams>(
      {.name = "contour.reconstruct",
       .revision = 2,
       .summary = "A terrain from its contours or from a network, at any resolution",
       .source = "P2 sec. 3.2",
       .in = {{"contours", ValueKind::contours, "nested closed contours", false},
              {"tin", ValueKind::tin, "or a network with heights", false}},
       .out = {{"terrain", ValueKind::terrain, "heights in metres"}}},
      reconstruct);
}

}  // namespace seamount::recipe
