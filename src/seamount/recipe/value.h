// What flows along the edges of a recipe: immutable values, shared and never copied, each of a kind (kind.h).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "seamount/recipe/kind.h"

namespace seamount::recipe {

/// A value and its kind. K is a kind (kinds.h); its Type is what the value holds.
class Value {
 public:
  Value() = default;
  Value(const Kind& kind, std::shared_ptr<const void> data) : kind_(&kind), data_(std::move(data)) {}

  template <class K>
  static Value of(typename K::Type value) {
    return {K::kind(), std::make_shared<const typename K::Type>(std::move(value))};
  }

  bool empty() const { return kind_ == nullptr; }
  /// REQUIRES: not empty.
  const Kind& kind() const { return *kind_; }

  template <class K>
  bool is() const {
    return kind_ == &K::kind();
  }
  /// REQUIRES: is<K>().
  template <class K>
  const typename K::Type& get() const {
    return *static_cast<const typename K::Type*>(data_.get());
  }

  /// Where the value lies; nullptr for what lies nowhere in particular: pictures, drawings, reports.
  const GridFrame* frame() const { return kind_->frame(data_.get()); }
  /// Where it lies on the Earth or in local metres; nothing for what lies nowhere.
  std::optional<Extent> extent() const { return kind_->extent(data_.get()); }
  /// The same elsewhere; itself if it lies nowhere.
  Value brought(const Destination& to) const {
    return kind_->bring ? Value(*kind_, kind_->bring(data_.get(), to)) : *this;
  }
  /// The same with values in all its cells; itself if they are known. Says through `run` what was filled.
  Value without_voids(const std::string& name, const RunContext& run) const {
    auto filled = kind_->without_voids ? kind_->without_voids(data_.get(), name, run) : nullptr;
    return filled ? Value(*kind_, std::move(filled)) : *this;
  }
  /// Bytes of the payload, about.
  size_t bytes() const { return kind_->bytes(data_.get()); }
  void write(Writer& writer) const { kind_->write(writer, data_.get()); }

 private:
  const Kind* kind_ = nullptr;
  std::shared_ptr<const void> data_;
};

using Values = std::map<std::string, Value, std::less<>>;

}  // namespace seamount::recipe
