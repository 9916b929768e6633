// What flows along the edges of a recipe: immutable values, shared and never copied.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "seamount/base/fields.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/report.h"
#include "seamount/model/tin.h"

namespace seamount::recipe {

/// terrain: heights in metres; labels: regions; field: any other scalar per cell; image: a picture; drawing: areas and
/// lines; tin: a triangulated network; contours: nested closed contours; report: measured numbers and plots.
enum class ValueKind { terrain, labels, field, image, drawing, tin, contours, report };

/// A value and its kind. terrain and field are both rasters of float and differ in what they may be connected to.
class Value {
 public:
  Value() = default;
  static Value terrain(HeightField grid) {
    return {ValueKind::terrain, std::make_shared<const HeightField>(std::move(grid))};
  }
  static Value field(ScalarField grid) {
    return {ValueKind::field, std::make_shared<const ScalarField>(std::move(grid))};
  }
  static Value labels(LabelMap grid) { return {ValueKind::labels, std::make_shared<const LabelMap>(std::move(grid))}; }
  static Value image(Image picture) { return {ValueKind::image, std::make_shared<const Image>(std::move(picture))}; }
  static Value drawing(Drawing shapes) {
    return {ValueKind::drawing, std::make_shared<const Drawing>(std::move(shapes))};
  }
  static Value tin(Tin network) { return {ValueKind::tin, std::make_shared<const Tin>(std::move(network))}; }
  static Value contours(ContourSet set) {
    return {ValueKind::contours, std::make_shared<const ContourSet>(std::move(set))};
  }

  static Value report(Report measured) {
    return {ValueKind::report, std::make_shared<const Report>(std::move(measured))};
  }

  ValueKind kind() const { return kind_; }
  /// REQUIRES: kind() holds that type.
  const HeightField& heights() const { return get<HeightField>(); }
  const ScalarField& scalars() const { return get<ScalarField>(); }
  const LabelMap& regions() const { return get<LabelMap>(); }
  const Image& picture() const { return get<Image>(); }
  const Drawing& shapes() const { return get<Drawing>(); }
  const Tin& network() const { return get<Tin>(); }
  const ContourSet& contour_set() const { return get<ContourSet>(); }
  const Report& measured() const { return get<Report>(); }

  /// Where the value lies; nullptr for pictures, drawings and reports.
  const GridFrame* frame() const;
  /// Bytes of the payload.
  size_t bytes() const;

 private:
  using Data = std::variant<std::shared_ptr<const Grid<float>>, std::shared_ptr<const LabelMap>,
                            std::shared_ptr<const Image>, std::shared_ptr<const Drawing>, std::shared_ptr<const Tin>,
                            std::shared_ptr<const ContourSet>, std::shared_ptr<const Report>>;
  Value(ValueKind kind, Data data) : kind_(kind), data_(std::move(data)) {}
  template <class T>
  const T& get() const {
    return *std::get<std::shared_ptr<const T>>(data_);
  }

  ValueKind kind_ = ValueKind::terrain;
  Data data_;
};

using Values = std::map<std::string, Value, std::less<>>;

std::string_view kind_name(ValueKind kind);

}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::ValueKind> {
  static constexpr std::array<std::string_view, 8> names = {"terrain", "labels", "field",    "image",
                                                            "drawing", "tin",    "contours", "report"};
};
