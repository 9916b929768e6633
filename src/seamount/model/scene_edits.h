// What people do to the objects of a scene by hand, between two iterations (P3 sec. 1.7.1). An edit acts after
// iteration `after` (0: before the first) of the scene, or of the window that grows. Objects are named by their number,
// or as the nearest one of a class to a place.
#pragma once

#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount {

/// Which object is meant.
struct ObjectChoice {
  int id = 0;
  std::string class_name;
  Vec2 near;
  bool operator==(const ObjectChoice&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&ObjectChoice::id, "id", "", at_least(0), "number of the object; 0: the nearest one"),
                      field(&ObjectChoice::class_name, "class", "its class; empty: any"),
                      field(&ObjectChoice::near, "near", "without a number: the object nearest to this place"));
  }
};

struct AddEdit {
  static constexpr std::string_view kTool = "add", kAbout = "a new object, also where nothing would grow";
  int after = 0;
  std::string class_name;
  Polyline points;
  bool locked = true;
  bool keep = true;
  double size = 1.0;
  bool operator==(const AddEdit&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&AddEdit::after, "after", "", at_least(0), "iteration after which it is done"),
                      field(&AddEdit::class_name, "class", "of the catalogue"),
                      field(&AddEdit::points, "points", "its skeleton: one point, a curve, or the outline of a region"),
                      field(&AddEdit::locked, "locked", "its points stay where they are"),
                      field(&AddEdit::keep, "keep", "it lives whatever its fitness"),
                      field(&AddEdit::size, "size", "", between(1e-3, 1e3), "times the size of its class"));
  }
};

struct MoveEdit {
  static constexpr std::string_view kTool = "move", kAbout = "an object elsewhere";
  int after = 0;
  ObjectChoice object;
  Vec2 by;
  bool operator==(const MoveEdit&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&MoveEdit::after, "after", "", at_least(0), "iteration after which it is done"),
                      field(&MoveEdit::object, "object", "which one"),
                      field(&MoveEdit::by, "by", "metres east and north"));
  }
};

enum class Handle : unsigned char { gaussian, kelvinlet };
template <>
struct Choices<Handle> {
  static constexpr std::array<std::string_view, 2> names = {"gaussian", "kelvinlet"};
};

struct BendEdit {
  static constexpr std::string_view kTool = "bend", kAbout = "a curve or an outline drawn along by a handle";
  int after = 0;
  ObjectChoice object;
  Vec2 at;
  Vec2 by;
  double radius_m = 100.0;
  Handle handle = Handle::gaussian;
  bool lock = true;
  bool operator==(const BendEdit&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&BendEdit::after, "after", "", at_least(0), "iteration after which it is done"),
                      field(&BendEdit::object, "object", "which one"),
                      field(&BendEdit::at, "at", "where the handle takes hold"),
                      field(&BendEdit::by, "by", "metres east and north"),
                      field(&BendEdit::radius_m, "radius_m", "m", between(1e-3, 1e7), "how far it reaches"),
                      field(&BendEdit::handle, "handle", "falloff of the handle: gaussian or kelvinlet"),
                      field(&BendEdit::lock, "lock", "points that moved by more than half of it stay there"));
  }
};

struct HoldEdit {
  static constexpr std::string_view kTool = "hold", kAbout = "points of a skeleton locked, hindered or set free";
  int after = 0;
  ObjectChoice object;
  Vec2 at;
  double radius_m = 1e6;
  double hold = 1.0;
  bool operator==(const HoldEdit&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&HoldEdit::after, "after", "", at_least(0), "iteration after which it is done"),
                      field(&HoldEdit::object, "object", "which one"),
                      field(&HoldEdit::at, "at", "its points around this place"),
                      field(&HoldEdit::radius_m, "radius_m", "m", between(0, 1e9), "so far from it"),
                      field(&HoldEdit::hold, "hold", "", between(0, 1), "0 free, 1 locked, hindered in between"));
  }
};

struct DeleteEdit {
  static constexpr std::string_view kTool = "delete", kAbout = "an object taken away";
  int after = 0;
  ObjectChoice object;
  bool operator==(const DeleteEdit&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&DeleteEdit::after, "after", "", at_least(0), "iteration after which it is done"),
                      field(&DeleteEdit::object, "object", "which one"));
  }
};

using SceneEdit = std::variant<AddEdit, MoveEdit, BendEdit, HoldEdit, DeleteEdit>;

}  // namespace seamount
