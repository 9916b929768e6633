#include "seamount/io/gazebo_sdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"

namespace seamount::io::sdf {
namespace {

/// To a tenth of a millimetre.
std::string metres(double value) { return format_number(std::round(value * 1e4) / 1e4 + 0.0); }

/// The height of the lowest code is not rounded: it is exact in the PNG's codes.
std::string exact(double value) { return format_number(value); }

std::string heightmap(const Ground& ground, const std::string& uri, bool visual) {
  std::string text = fmt::format(
      "<heightmap>\n"
      "              <uri>{}height.png</uri>\n"
      "              <size>{}</size>\n"
      "              <pos>{}</pos>\n",
      uri, heightmap_size(ground), visual ? heightmap_pos(ground) : "0 0 0");
  if (visual && ground.textured)
    text += fmt::format(
        "              <texture>\n"
        "                <diffuse>{0}ground.png</diffuse>\n"
        "                <normal>{0}flat_normal.png</normal>\n"
        "                <size>{1}</size>\n"
        "              </texture>\n",
        uri, metres(ground.size_m));
  return text + "            </heightmap>";
}

/// A picture or mesh of OBJ's axes, y up, is turned to z up.
std::string geometry(const Ground& ground, const std::string& uri, bool visual) {
  const std::string turned = "          <pose>0 0 0 1.5707963267948966 0 0</pose>\n";
  std::string pose;
  if (ground.mesh) pose = turned;
  if (!ground.mesh && !visual) pose = fmt::format("          <pose>{} 0 0 0</pose>\n", heightmap_pos(ground));
  const std::string shape = ground.mesh
                                ? fmt::format("<mesh>\n              <uri>{}ground.obj</uri>\n            </mesh>", uri)
                                : heightmap(ground, uri, visual);
  return fmt::format("{}          <geometry>\n            {}\n          </geometry>\n", pose, shape);
}

std::string ground_model(const Ground& ground, const std::string& name, const std::string& uri) {
  return fmt::format(
      "    <model name=\"{}\">\n"
      "      <static>true</static>\n"
      "      <link name=\"ground\">\n"
      "        <visual name=\"visual\">\n{}        </visual>\n"
      "        <collision name=\"collision\">\n{}        </collision>\n"
      "      </link>\n"
      "    </model>\n",
      xml_escaped(name), geometry(ground, uri, true), geometry(ground, uri, false));
}

std::string sea_model(double size_m) {
  return fmt::format(
      "    <model name=\"sea\">\n"
      "      <static>true</static>\n"
      "      <link name=\"surface\">\n"
      "        <visual name=\"visual\">\n"
      "          <cast_shadows>false</cast_shadows>\n"
      "          <transparency>0.6</transparency>\n"
      "          <geometry>\n"
      "            <plane>\n"
      "              <normal>0 0 1</normal>\n"
      "              <size>{0} {0}</size>\n"
      "            </plane>\n"
      "          </geometry>\n"
      "          <material>\n"
      "            <ambient>0.05 0.25 0.35 0.4</ambient>\n"
      "            <diffuse>0.05 0.25 0.35 0.4</diffuse>\n"
      "            <specular>0.5 0.5 0.5 0.4</specular>\n"
      "          </material>\n"
      "        </visual>\n"
      "      </link>\n"
      "    </model>\n",
      metres(size_m));
}

const char* const kSun =
    "    <light name=\"sun\" type=\"directional\">\n"
    "      <cast_shadows>true</cast_shadows>\n"
    "      <pose>0 0 1000 0 0 0</pose>\n"
    "      <diffuse>0.9 0.9 0.85 1</diffuse>\n"
    "      <specular>0.2 0.2 0.2 1</specular>\n"
    "      <direction>-0.5 -0.3 -0.8</direction>\n"
    "    </light>\n";

/// A world that names any system gets no others by itself.
const char* const kBuoyancy =
    "    <plugin filename=\"gz-sim-physics-system\" name=\"gz::sim::systems::Physics\"/>\n"
    "    <plugin filename=\"gz-sim-user-commands-system\" name=\"gz::sim::systems::UserCommands\"/>\n"
    "    <plugin filename=\"gz-sim-scene-broadcaster-system\" name=\"gz::sim::systems::SceneBroadcaster\"/>\n"
    "    <plugin filename=\"gz-sim-buoyancy-system\" name=\"gz::sim::systems::Buoyancy\">\n"
    "      <graded_buoyancy>\n"
    "        <default_density>1025</default_density>\n"
    "        <density_change>\n"
    "          <above_depth>0</above_depth>\n"
    "          <density>1.225</density>\n"
    "        </density_change>\n"
    "      </graded_buoyancy>\n"
    "    </plugin>\n";

std::string globe_place(const GlobePlace& place) {
  return fmt::format(
      "    <spherical_coordinates>\n"
      "      <surface_model>EARTH_WGS84</surface_model>\n"
      "      <world_frame_orientation>ENU</world_frame_orientation>\n"
      "      <latitude_deg>{:.9f}</latitude_deg>\n"
      "      <longitude_deg>{:.9f}</longitude_deg>\n"
      "      <elevation>0</elevation>\n"
      "      <heading_deg>{:.6f}</heading_deg>\n"
      "    </spherical_coordinates>\n",
      place.latitude_deg, place.longitude_deg, place.heading_deg);
}

}  // namespace

std::string heightmap_size(const Ground& ground) {
  return fmt::format("{0} {0} {1}", metres(ground.size_m), exact(ground.range_m));
}

std::string heightmap_pos(const Ground& ground) { return "0 0 " + exact(ground.low_m); }

std::string world_file(const World& world, const Ground& ground) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n" +
         fmt::format("  <world name=\"{}\">\n", xml_escaped(world.name)) +
         "    <physics name=\"default\" type=\"ode\">\n"
         "      <max_step_size>0.001</max_step_size>\n"
         "      <real_time_factor>1</real_time_factor>\n"
         "      <real_time_update_rate>1000</real_time_update_rate>\n"
         "    </physics>\n" +
         (world.buoyancy ? kBuoyancy : "") +
         "    <gravity>0 0 -9.81</gravity>\n"
         "    <scene>\n"
         "      <ambient>0.4 0.4 0.4 1</ambient>\n"
         "      <background>0.6 0.75 0.9 1</background>\n"
         "      <shadows>true</shadows>\n"
         "    </scene>\n" +
         (world.place ? globe_place(*world.place) : "") + kSun +
         ground_model(ground, "ground", xml_escaped(ground.folder) + "/") +
         (world.sea ? sea_model(ground.size_m) : "") + world.things + "  </world>\n</sdf>\n";
}

std::string thing_model(const ThingModel& thing) {
  const double x = thing.rotation[0], y = thing.rotation[1], z = thing.rotation[2], w = thing.rotation[3];
  const double roll = std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
               pitch = std::asin(std::clamp(2 * (w * y - z * x), -1.0, 1.0)),
               yaw = std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  const std::string scale = metres(thing.scale);
  std::string text = fmt::format(
      "    <model name=\"{0}\">\n"
      "      <static>true</static>\n"
      "      <pose>{1} {2} {3} {4:.6f} {5:.6f} {6:.6f}</pose>\n"
      "      <link name=\"body\">\n"
      "        <visual name=\"visual\">\n"
      "          <geometry>\n"
      "            <mesh><uri>{7}</uri><scale>{8} {8} {8}</scale></mesh>\n"
      "          </geometry>\n"
      "        </visual>\n",
      xml_escaped(thing.name), metres(thing.place[0]), metres(thing.place[1]), metres(thing.place[2]), roll + 0.0,
      pitch + 0.0, yaw + 0.0, xml_escaped(thing.mesh), scale);
  if (thing.collides)
    text += fmt::format(
        "        <collision name=\"collision\">\n"
        "          <pose>0 0 {} 0 0 0</pose>\n"
        "          <geometry>\n"
        "            <box><size>{} {} {}</size></box>\n"
        "          </geometry>\n"
        "        </collision>\n",
        metres(0.5 * thing.box[2]), metres(thing.box[0]), metres(thing.box[1]), metres(thing.box[2]));
  return text + "      </link>\n    </model>\n";
}

std::string model_file(const Ground& ground, const std::string& name) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n" +
         ground_model(ground, name, "model://" + xml_escaped(name) + "/") + "</sdf>\n";
}

std::string model_config(const std::string& name) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<model>\n"
      "  <name>{}</name>\n"
      "  <version>1.0</version>\n"
      "  <sdf version=\"1.7\">model.sdf</sdf>\n"
      "  <author>\n"
      "    <name>Seamount</name>\n"
      "  </author>\n"
      "  <description>Ground</description>\n"
      "</model>\n",
      xml_escaped(name));
}

}  // namespace seamount::io::sdf
