#include "seamount/recipe/one_frame.h"

#include <cmath>

#include "seamount/io/reproject.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

bool is_raster(const Value& value) {
  return value.is<kinds::Terrain>() || value.is<kinds::Field>() || value.is<kinds::Labels>();
}

/// The input that the others come to.
const Port* find_reference(const Operator& op, const Values& in) {
  for (const Port& port : op.in) {
    const auto found = in.find(port.name);
    if (found != in.end() && port.placing != Placing::anywhere && found->second.frame() != nullptr) return &port;
  }
  return nullptr;
}

[[noreturn]] void fail_apart(const std::string& what, const Extent& its, const std::string& whose,
                             const Extent& wanted) {
  const std::string advice =
      its.crs.empty() != wanted.crs.empty()
          ? std::string("; ") + (its.crs.empty() ? "it" : whose) + " says nothing of its coordinate system"
          : "";
  throw IncompatibleInputs(what + ": lies nowhere on " + whose + ": " + extent_text(its) + "; " + whose + ": " +
                           extent_text(wanted) + advice);
}

/// Brings the inputs of one operator to a frame.
class Meeting {
 public:
  Meeting(const Operator& op, Values& in, const GridFrame& domain, const RunContext& run)
      : in_(in), frame_(domain), run_(run) {
    reference_ = find_reference(op, in);
    if (reference_ == nullptr) {
      find_system(op);
      return;
    }
    const bool domain_counts = reference_->placing == Placing::system && !domain.crs.empty();
    raster_ = is_raster(in.at(reference_->name));
    if (domain_counts) {
      reference_ = nullptr;
      return;
    }
    frame_ = *in.at(reference_->name).frame();
    whose_ = "'" + reference_->name + "'";
  }

  /// Beside a raster.
  Meeting(Values& in, GridFrame frame, std::string whose, const RunContext& run)
      : in_(in), frame_(std::move(frame)), run_(run), reference_(&kRaster), raster_(true), whose_(std::move(whose)) {}

  void bring(const Port& port) {
    const auto found = in_.find(port.name);
    if (found == in_.end() || port.placing == Placing::anywhere || &port == reference_) return;
    Value& value = found->second;
    const std::optional<Extent> extent = value.extent();
    if (!extent) return;
    const bool both = !extent->crs.empty() && !frame_.crs.empty();
    const bool onto_cells = port.placing == Placing::cells && reference_ != nullptr && raster_ && is_raster(value);
    if (both && (onto_cells ? *value.frame() != frame_ : extent->crs != frame_.crs)) {
      check_meets(port, io::in_system(*extent, frame_.crs));
      value = value.brought({frame_, onto_cells, run_});
      return;
    }
    if (onto_cells && !both) return;  // without a place only the size counts, which operators check
    check_meets(port, *extent);
    if (extent->crs.empty() != frame_.crs.empty() && (reference_ != nullptr || !frame_.crs.empty()))
      run_.say(port.name + ": " + (extent->crs.empty() ? "it" : whose_) +
               " says nothing of its coordinate system; their numbers are taken for the same metres");
  }

  /// What all inputs cover; nothing if they lie nowhere.
  std::optional<Extent> cover(const Operator& op) const {
    std::optional<Extent> all;
    for (const Port& port : op.in) {
      const auto found = in_.find(port.name);
      if (found == in_.end() || port.placing == Placing::anywhere) continue;
      const bool counts = raster_ ? is_raster(found->second) : true;
      const std::optional<Extent> extent = counts ? found->second.extent() : std::nullopt;
      if (!extent) continue;
      if (!all) all = extent;
      all->include(*extent);
      if (all->crs.empty()) all->crs = extent->crs;
    }
    return all;
  }

 private:
  /// Without a raster, a domain in local metres and drawings in some system: the first one's.
  void find_system(const Operator& op) {
    if (!frame_.crs.empty()) return;
    for (const Port& port : op.in) {
      const auto found = in_.find(port.name);
      const std::optional<Extent> extent = found != in_.end() ? found->second.extent() : std::nullopt;
      if (!extent || extent->crs.empty()) continue;
      frame_ = placed_domain(frame_, *extent);
      return;
    }
  }

  void check_meets(const Port& port, const Extent& extent) const {
    if (port.placing == Placing::system || (reference_ == nullptr && frame_.crs.empty())) return;
    const Extent own = Extent::of(frame_);
    if (!extent.overlaps(own)) fail_apart(port.name, extent, whose_, own);
  }

  static inline const Port kRaster;

  Values& in_;
  GridFrame frame_;
  const RunContext& run_;
  const Port* reference_ = nullptr;
  bool raster_ = false;
  std::string whose_ = "the document's domain";
};

}  // namespace

GridFrame placed_domain(GridFrame domain, const Extent& extent) {
  if (!domain.crs.empty()) return domain;
  domain.crs = extent.crs;
  if (extent.overlaps(Extent::of(domain))) return domain;
  const auto in_cells = [&](double metres) { return std::round(metres / domain.cell_m) * domain.cell_m; };
  domain.west_m = extent.west + in_cells(0.5 * (extent.east - extent.west - domain.width_m()));
  domain.north_m = extent.north - in_cells(0.5 * (extent.north - extent.south - domain.height_m()));
  return domain;
}

Together bring_together(const Operator& op, Values in, const GridFrame& domain, const RunContext& run) {
  Together together{std::move(in), domain};
  Meeting meeting(op, together.in, domain, run);
  for (const Port& port : op.in) meeting.bring(port);
  if (const auto cover = meeting.cover(op)) together.domain = placed_domain(domain, *cover);
  for (const Port& port : op.in) {
    const auto found = together.in.find(port.name);
    if (found != together.in.end() && !port.voids) found->second = found->second.without_voids(port.name, run);
  }
  return together;
}

Value brought_beside(const Port& port, Value value, const GridFrame& frame, const std::string& whose,
                     const RunContext& run) {
  Values in{{port.name, std::move(value)}};
  Meeting(in, frame, whose, run).bring(port);
  return in.begin()->second;
}

Drawing bring_drawing(Drawing drawing, GridFrame& domain, const std::string& path) {
  const auto extent = kinds::Drawing::kind().extent(&drawing);
  if (!extent) return drawing;
  if (domain.crs.empty()) {
    domain = placed_domain(domain, *extent);
    return drawing;
  }
  if (!drawing.crs.empty()) drawing = io::in_system(std::move(drawing), domain.crs);
  const auto moved = kinds::Drawing::kind().extent(&drawing);
  if (!moved->overlaps(Extent::of(domain)))
    throw IoError(path, "lies nowhere on the document's domain: " + extent_text(*moved) +
                            "; the domain: " + extent_text(Extent::of(domain)));
  return drawing;
}

}  // namespace seamount::recipe
