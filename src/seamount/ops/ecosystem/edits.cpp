#include "seamount/ops/ecosystem/edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "seamount/base/text.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/skeleton/bend.h"
#include "seamount/ops/ecosystem/environment.h"
#include "seamount/ops/ecosystem/rules.h"

namespace seamount::ecosystem {
namespace {

/// Edits done to a copy of a scene, one after another.
class Editor {
 public:
  Editor(Scene& scene, int window) : scene_(scene), window_(window) {}

  void apply(const SceneEdit& edit, std::string place) {
    place_ = std::move(place);
    std::visit([this](const auto& e) { apply(e); }, edit);
  }

 private:
  [[noreturn]] void fail(const std::string& member, const std::string& why) const {
    throw InvalidArgument(place_ + "." + member, why);
  }

  SceneObject& find(const ObjectChoice& choice) {
    if (choice.id != 0) {
      for (SceneObject& object : scene_.objects) {
        if (object.id != static_cast<uint64_t>(choice.id)) continue;
        if (object.window == window_) return object;
        fail("object.id", "object " + std::to_string(choice.id) +
                              " lives in another frame of the scene: edit it while " +
                              (object.window == 0 ? "the whole scene" : "its window") + " grows");
      }
      fail("object.id", "there is no object " + std::to_string(choice.id));
    }
    const int of_class =
        choice.class_name.empty()
            ? -1
            : static_cast<int>(class_named(scene_.catalogue, choice.class_name, place_ + ".object.class"));
    SceneObject* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (SceneObject& object : scene_.objects) {
      if (object.window != window_ || (of_class >= 0 && object.of_class != of_class)) continue;
      const int32_t owner = 0;
      const geom::NearestSkeleton hit = geom::SkeletonIndex({&object.skeleton, 1}, {&owner, 1}).nearest(choice.near);
      const double distance = hit.inside ? 0.0 : hit.distance;
      if (distance >= least) continue;
      least = distance;
      best = &object;
    }
    if (best == nullptr)
      fail("object", "there is no object" + (of_class < 0 ? "" : " of the class '" + choice.class_name + "'"));
    return *best;
  }

  void apply(const AddEdit& edit) {
    const size_t c = class_named(scene_.catalogue, edit.class_name, place_ + ".class");
    SceneObject object;
    object.of_class = static_cast<int>(c);
    object.skeleton.kind = scene_.catalogue.classes[c].skeleton;
    object.skeleton.points = edit.points;
    check_skeleton(object.skeleton, "points");
    if (edit.locked) object.skeleton.hold.assign(object.skeleton.points.size(), 1.0F);
    object.id = scene_.next_id++;
    object.size = edit.size;
    object.born = iterations_in(scene_, window_);
    object.window = window_;
    object.keep = edit.keep;
    scene_.objects.push_back(std::move(object));
  }

  /// Counter-clockwise, simple, in the frame; or an error.
  void check_skeleton(Skeleton& skeleton, const std::string& member) const {
    const size_t count = skeleton.points.size();
    const char* const needs[] = {"one place", "two places or more", "three places or more"};
    const auto kind = static_cast<size_t>(skeleton.kind);
    if (count < kind + 1 || (kind == 0 && count != 1))
      fail(member, std::string("a ") + std::string(Choices<SkeletonKind>::names[kind]) + " has " + needs[kind] +
                       ", found " + std::to_string(count));
    const GridFrame& frame = frame_of(scene_, window_);
    for (const Vec2 p : skeleton.points) {
      if (p.x >= frame.west_m && p.x <= frame.east_m() && p.y >= frame.south_m() && p.y <= frame.north_m) continue;
      fail(member, "the place " + geom::format_place(p) + " lies outside of the frame");
    }
    if (skeleton.kind != SkeletonKind::region) return;
    if (const auto defect = geom::find_defect({skeleton.points, {}})) fail(member, "the outline " + *defect);
    if (geom::signed_area(skeleton.points) > 0.0) return;
    std::reverse(skeleton.points.begin(), skeleton.points.end());
    std::reverse(skeleton.hold.begin(), skeleton.hold.end());
  }

  void apply(const MoveEdit& edit) {
    SceneObject& object = find(edit.object);
    Skeleton moved = geom::moved(object.skeleton, edit.by);
    check_skeleton(moved, "by");
    object.skeleton = std::move(moved);
  }

  void apply(const BendEdit& edit) {
    SceneObject& object = find(edit.object);
    if (object.skeleton.kind == SkeletonKind::point) fail("object", "a point does not bend; move it");
    Skeleton bent = geom::bent(object.skeleton, {edit.at, edit.by, edit.radius_m, edit.handle}, edit.lock);
    check_skeleton(bent, "by");
    object.skeleton = std::move(bent);
  }

  void apply(const HoldEdit& edit) {
    Skeleton& skeleton = find(edit.object).skeleton;
    skeleton = geom::held(skeleton, edit.at, edit.radius_m, edit.hold);
  }

  void apply(const DeleteEdit& edit) {
    const uint64_t id = find(edit.object).id;
    std::erase_if(scene_.objects, [&](const SceneObject& object) { return object.id == id; });
  }

  Scene& scene_;
  int window_;
  std::string place_;
};

}  // namespace

bool apply_edits(const std::vector<SceneEdit>& edits, Scene& scene, int window, const RunContext& run) {
  static_cast<void>(run);
  Scene edited = scene;
  Editor editor(edited, window);
  bool any = false;
  for (size_t i = 0; i < edits.size(); ++i) {
    const int after = std::visit([](const auto& e) { return e.after; }, edits[i]);
    if (after != iterations_in(scene, window)) continue;
    editor.apply(edits[i], "edits[" + std::to_string(i) + "]");
    any = true;
  }
  if (any) scene = std::move(edited);
  return any;
}

}  // namespace seamount::ecosystem
