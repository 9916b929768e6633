// The text of Gazebo's files (SDF 1.7). Not part of the public interface; gazebo.h puts them together.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace seamount::io::sdf {

/// The ground model, around the world's origin.
struct Ground {
  std::string folder;     ///< of its files, as the world file names it
  bool mesh = false;      ///< ground.obj, else height.png
  bool textured = false;  ///< height maps; meshes know their textures
  double size_m = 0.0;    ///< of its longer side
  double low_m = 0.0;     ///< height of a height map's lowest code
  double range_m = 0.0;   ///< up to its highest
};

struct GlobePlace {
  double latitude_deg = 0.0, longitude_deg = 0.0;
  double heading_deg = 0.0;  ///< of the world's y, anticlockwise from true north
};

struct World {
  std::string name;
  std::optional<GlobePlace> place;  ///< of the origin
  bool sea = false;                 ///< a sheet at z = 0, as large as the ground
  bool buoyancy = false;
  std::string things;  ///< their models, as text
};

/// A thing as a static model.
struct ThingModel {
  std::string name, mesh;  ///< the mesh as the world file names it, z up
  std::array<double, 3> place{};
  std::array<float, 4> rotation = {0.F, 0.F, 0.F, 1.F};
  double scale = 1.0;
  bool collides = false;
  std::array<double, 3> box{};  ///< of a collision, its size and, upright over the foot, its place
};
std::string thing_model(const ThingModel& thing);

/// What stands in <size> and <pos> of a height map.
std::string heightmap_size(const Ground& ground);
std::string heightmap_pos(const Ground& ground);

std::string world_file(const World& world, const Ground& ground);
std::string model_file(const Ground& ground, const std::string& name);
std::string model_config(const std::string& name);

}  // namespace seamount::io::sdf
