#include "brindle/shapes.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <variant>

#include "brindle/base/memory.h"
#include "brindle/base/number_text.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/shapes/flat_parts.h"
#include "brindle/shapes/implicit_shapes.h"
#include "brindle/shapes/noise.h"
#include "brindle/shapes/parametric_shapes.h"

namespace brindle {
namespace {

using Parameter = ShapeParameter;

/// The values of all parameters of a shape.
class Values {
 public:
  explicit Values(const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters) values_[parameter.name] = parameter.standard;
  }
  void set(std::string_view name, double value) { values_.at(name) = value; }
  float real(std::string_view name) const { return static_cast<float>(values_.at(name)); }
  int whole(std::string_view name) const { return static_cast<int>(values_.at(name)); }
  std::uint32_t seed(std::string_view name) const {
    return static_cast<std::uint32_t>(values_.at(name));
  }

 private:
  std::map<std::string_view, double> values_;
};

struct Shape {
  std::string_view name;
  std::string_view help;
  std::vector<Parameter> parameters;
  /// Shapes with a formula can be made in parts.
  std::variant<std::function<Mesh(const Values&, const Progress&)>,
               std::function<StripShape(const Values&)>>
      make;
};

Parameter length(std::string_view name, double standard, std::string_view help) {
  return {std::string(name), standard, 1e-3, 1e3, false, std::string(help)};
}

Parameter resolution(int standard, int lower, int upper, std::string_view help) {
  return {"resolution",
          static_cast<double>(standard),
          static_cast<double>(lower),
          static_cast<double>(upper),
          true,
          std::string(help)};
}

Parameter seed(std::string_view name, std::uint32_t standard) {
  return {std::string(name),           static_cast<double>(standard), 0, 4294967295.0, true,
          "another one, another shape"};
}

Shape plane() {
  const PlaneShape s;
  return {"plane",
          "a rectangle",
          {length("width", s.width, "along x"), length("height", s.height, "along y"),
           resolution(s.resolution, 1, 5000, "edges along x")},
          [](const Values& v) {
            return plane_strips({.width = v.real("width"),
                                 .height = v.real("height"),
                                 .resolution = v.whole("resolution")});
          }};
}

Shape cylinder() {
  const CylinderShape s;
  return {"cylinder",
          "the open side surface of a cylinder",
          {length("radius", s.radius, "radius"), length("height", s.height, "along z"),
           resolution(s.resolution, 3, 10000, "edges around")},
          [](const Values& v) {
            return cylinder_strips({.radius = v.real("radius"),
                                    .height = v.real("height"),
                                    .resolution = v.whole("resolution")});
          }};
}

Shape tube() {
  const TubeShape s;
  return {"tube",
          "an open tube along an arc: a sleeve, a vase",
          {length("radius", s.radius, "radius"),
           length("length", s.length, "along the arc"),
           {"bend", s.bend_deg, 0, 360, false, "how much the arc turns, in degrees"},
           {"bulge", s.bulge, 0, 0.9, false, "wider by this share below, narrower above"},
           {"taper", s.taper, 0.1, 10, false, "radius of the upper end over that of the lower"},
           resolution(s.resolution, 3, 5000, "edges around")},
          [](const Values& v) {
            const TubeShape shape{.radius = v.real("radius"),
                                  .length = v.real("length"),
                                  .bend_deg = v.real("bend"),
                                  .bulge = v.real("bulge"),
                                  .taper = v.real("taper"),
                                  .resolution = v.whole("resolution")};
            const double widest =
                static_cast<double>(shape.radius) * (1 + shape.bulge) * std::max(1.0f, shape.taper);
            if (widest * static_cast<double>(shape.bend_deg) * 0.0174533 >= shape.length) {
              throw Error(
                  "shape 'tube': it would cut into itself; lower bend, radius, bulge or "
                  "taper, or raise length");
            }
            return tube_strips(shape);
          }};
}

Shape sphere() {
  const SphereShape s;
  return {"sphere",
          "a divided icosahedron",
          {length("radius", s.radius, "radius"),
           resolution(s.resolution, 1, 1500, "edges along an edge of the icosahedron")},
          [](const Values& v) {
            return sphere_strips({.radius = v.real("radius"), .resolution = v.whole("resolution")});
          }};
}

Shape torus() {
  const TorusShape s;
  return {"torus",
          "a ring",
          {length("major", s.major, "radius of the ring"),
           length("minor", s.minor, "radius of the tube, below major"),
           resolution(s.resolution, 4, 10000, "edges along the ring")},
          [](const Values& v) {
            if (v.real("minor") >= 0.999f * v.real("major")) {
              throw Error("shape 'torus': minor must be below major; make one of them " +
                          std::string("smaller or larger"));
            }
            return torus_strips({.major = v.real("major"),
                                 .minor = v.real("minor"),
                                 .resolution = v.whole("resolution")});
          }};
}

Shape trefoil() {
  const TrefoilShape s;
  return {
      "trefoil",
      "a tube along a trefoil knot",
      {{"radius", s.radius, 0.01, 0.25, false, "radius of the tube"},
       resolution(s.resolution, 3, 500, "edges around the tube")},
      [](const Values& v) {
        return trefoil_strips({.radius = v.real("radius"), .resolution = v.whole("resolution")});
      }};
}

Shape vessels() {
  const VesselsShape s;
  return {"vessels",
          "a branching tree of vessels",
          {{"generations", static_cast<double>(s.generations), 0, 7, true, "splits of the trunk"},
           {"radius", s.radius, 0.03, 0.3, false, "radius of the trunk, before scaling to size 2"},
           {"spread", s.spread, 0.1, 1.3, false, "angle of the branches, radians"},
           seed("seed", s.seed),
           resolution(s.resolution, 20, 800, "edges along one unit")},
          [](const Values& v, const Progress& progress) {
            return make_vessels({.generations = v.whole("generations"),
                                 .radius = v.real("radius"),
                                 .spread = v.real("spread"),
                                 .seed = v.seed("seed"),
                                 .resolution = v.whole("resolution")},
                                progress);
          }};
}

Shape molecule() {
  const MoleculeShape s;
  return {"molecule",
          "blended spheres",
          {{"atoms", static_cast<double>(s.atoms), 1, 200, true, "number of spheres"},
           {"blend", s.blend, 0.001, 0.3, false, "radius of the blends"},
           seed("seed", s.seed),
           resolution(s.resolution, 5, 800, "edges along one unit")},
          [](const Values& v, const Progress& progress) {
            return make_molecule({.atoms = v.whole("atoms"),
                                  .blend = v.real("blend"),
                                  .seed = v.seed("seed"),
                                  .resolution = v.whole("resolution")},
                                 progress);
          }};
}

Mesh checked_box(const BoxShape& shape, const Progress& progress) {
  const float room = std::min(shape.width, shape.depth);
  if (2 * shape.fillet > std::min(room, shape.height)) {
    throw Error("shape 'box': fillet must be at most half the shortest side");
  }
  // The flat rims of the hole and of the sides' fillets must not meet.
  if (shape.hole > 0 && 2 * shape.hole + 4 * shape.fillet > room) {
    throw Error(
        "shape 'box': the hole does not fit; hole + 2 fillet must be at most half of "
        "width and depth");
  }
  return make_box(shape, progress);
}

Shape box() {
  const BoxShape s;
  return {"box",
          "a block with rounded edges and a hole",
          {{"width", s.width, 0.1, 10, false, "along x"},
           {"depth", s.depth, 0.1, 10, false, "along y"},
           {"height", s.height, 0.1, 10, false, "along z"},
           {"fillet", s.fillet, 0.001, 5, false, "radius of the rounding"},
           {"hole", s.hole, 0, 5, false, "radius of the hole along z; 0 for none"},
           resolution(s.resolution, 5, 400, "edges along one unit")},
          [](const Values& v, const Progress& progress) {
            return checked_box({.width = v.real("width"),
                                .depth = v.real("depth"),
                                .height = v.real("height"),
                                .fillet = v.real("fillet"),
                                .hole = v.real("hole"),
                                .resolution = v.whole("resolution")},
                               progress);
          }};
}

Shape hemisphere() {
  const HemisphereShape s;
  return {
      "hemisphere",
      "half a sphere, open below",
      {length("radius", s.radius, "radius"),
       resolution(s.resolution, 1, 3000, "edges from pole to rim")},
      [](const Values& v) {
        return hemisphere_strips({.radius = v.real("radius"), .resolution = v.whole("resolution")});
      }};
}

Shape mobius() {
  const MobiusShape s;
  return {"mobius",
          "a strip with half a turn, its ends joined: unorientable",
          {length("radius", s.radius, "radius of the middle line"),
           length("width", s.width, "width of the strip, below 2 radius"),
           resolution(s.resolution, 1, 2000, "edges across the strip")},
          [](const Values& v) {
            if (v.real("width") >= 2 * v.real("radius")) {
              throw Error("shape 'mobius': width must be below twice the radius");
            }
            if (v.real("radius") / v.real("width") * v.real("resolution") > 2000) {
              throw Error("shape 'mobius': too many triangles; lower the resolution or the radius");
            }
            return mobius_strips({.radius = v.real("radius"),
                                  .width = v.real("width"),
                                  .resolution = v.whole("resolution")});
          }};
}

Shape sheets() {
  const SheetsShape s;
  return {"sheets",
          "sheets that meet in one edge: not a manifold",
          {{"count", static_cast<double>(s.count), 1, 32, true, "number of sheets"},
           length("width", s.width, "of a sheet"),
           length("height", s.height, "along z"),
           resolution(s.resolution, 1, 1000, "edges along the width")},
          [](const Values& v) {
            return sheets_strips({.count = v.whole("count"),
                                  .width = v.real("width"),
                                  .height = v.real("height"),
                                  .resolution = v.whole("resolution")});
          }};
}

Shape pieces() {
  const PiecesShape s;
  return {"pieces",
          "unconnected spheres, rings and cylinders",
          {{"count", static_cast<double>(s.count), 1, 100, true, "number of pieces"},
           resolution(s.resolution, 2, 300, "edges along an edge of the icosahedron")},
          [](const Values& v) {
            return pieces_strips({.count = v.whole("count"), .resolution = v.whole("resolution")});
          }};
}

Mesh checked_bracket(const BracketShape& shape) {
  if (!(shape.hole < room_for_hole(shape))) {
    throw Error(
        "shape 'bracket': the holes do not fit; hole must be below half of depth, and of what "
        "thickness and fillet leave of length and height");
  }
  return make_bracket(shape);
}

Shape bracket() {
  const BracketShape s;
  return {"bracket",
          "two plates at right angles with holes and a fillet, flat and coarse as from CAD",
          {{"length", s.length, 0.1, 10, false, "along x"},
           {"depth", s.depth, 0.1, 10, false, "along y"},
           {"height", s.height, 0.1, 10, false, "along z"},
           {"thickness", s.thickness, 0.01, 5, false, "of the plates"},
           {"fillet", s.fillet, 0.01, 5, false, "radius between the plates"},
           {"hole", s.hole, 0.01, 5, false, "radius of the holes"},
           resolution(s.resolution, 1, 200, "edges along a quarter of a circle")},
          [](const Values& v, const Progress&) {
            return checked_bracket({.length = v.real("length"),
                                    .depth = v.real("depth"),
                                    .height = v.real("height"),
                                    .thickness = v.real("thickness"),
                                    .fillet = v.real("fillet"),
                                    .hole = v.real("hole"),
                                    .resolution = v.whole("resolution")});
          }};
}

Mesh checked_gear(const GearShape& shape) {
  if (shape.tooth > shape.radius / 2) {
    throw Error("shape 'gear': tooth must be at most half of radius");
  }
  if (shape.bore > 0.8f * (shape.radius - shape.tooth)) {
    throw Error("shape 'gear': bore must be at most 0.8 of what tooth leaves of radius");
  }
  return make_gear(shape);
}

Shape gear() {
  const GearShape s;
  return {"gear",
          "a gear with a bore, flat and coarse as from CAD",
          {{"teeth", static_cast<double>(s.teeth), 3, 200, true, "number of teeth"},
           {"radius", s.radius, 0.1, 10, false, "to the tips of the teeth"},
           {"tooth", s.tooth, 0.001, 5, false, "height of a tooth"},
           {"width", s.width, 0.01, 10, false, "along z"},
           {"bore", s.bore, 0.01, 8, false, "radius of the bore"},
           resolution(s.resolution, 2, 20, "edges of the bore for each tooth")},
          [](const Values& v, const Progress&) {
            return checked_gear({.teeth = v.whole("teeth"),
                                 .radius = v.real("radius"),
                                 .tooth = v.real("tooth"),
                                 .width = v.real("width"),
                                 .bore = v.real("bore"),
                                 .resolution = v.whole("resolution")});
          }};
}

const std::vector<Shape>& catalogue() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = {plane(),   cylinder(),   tube(),     sphere(), torus(),
                              trefoil(), vessels(),    molecule(), box(),    bracket(),
                              gear(),    hemisphere(), mobius(),   sheets(), pieces()};
    for (Shape& shape : all) {
      shape.parameters.push_back(
          {"noise", 0, 0, 10, false, "displacement of vertices, in mean edge lengths"});
      shape.parameters.push_back(seed("noise_seed", 1));
    }
    return all;
  }();
  return shapes;
}

template <class Named>
std::string list(const std::vector<Named>& items) {
  std::string text;
  for (const Named& item : items) {
    if (!text.empty()) text += ", ";
    text += item.name;
  }
  return text;
}

/// "did you mean 'torus'? ", or "".
template <class Named>
std::string did_you_mean(std::string_view name, const std::vector<Named>& items) {
  std::vector<std::string> known;
  for (const Named& item : items) known.emplace_back(item.name);
  const std::string best = nearest(name, known);
  return best.empty() ? "" : "did you mean '" + best + "'? ";
}

const Shape& find_shape(std::string_view name) {
  for (const Shape& shape : catalogue()) {
    if (shape.name == name) return shape;
  }
  throw Error("unknown shape '" + std::string(name) + "'; " + did_you_mean(name, catalogue()) +
              "known are: " + list(catalogue()));
}

const Parameter& find_parameter(const Shape& shape, std::string_view name) {
  for (const Parameter& parameter : shape.parameters) {
    if (parameter.name == name) return parameter;
  }
  throw Error("shape '" + std::string(shape.name) + "' has no parameter '" + std::string(name) +
              "'; " + did_you_mean(name, shape.parameters) + "it has: " + list(shape.parameters));
}

std::string range(const Parameter& parameter) {
  return formatted("%s from %.10g to %.10g", parameter.whole ? "a whole number" : "a number",
                   parameter.lower, parameter.upper);
}

double parse_value(const Shape& shape, const Parameter& parameter, std::string_view text) {
  double value = 0;
  const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc() && end == text.data() + text.size();
  // NaN fails this test.
  const bool fits = value >= parameter.lower && value <= parameter.upper &&
                    (!parameter.whole || value == std::floor(value));
  if (!number || !fits) {
    throw Error("shape '" + std::string(shape.name) + "': parameter '" + parameter.name +
                "' must be " + range(parameter) + ", not '" + std::string(text) + "'");
  }
  return value;
}

/// The text up to the next separator; `text` keeps the rest.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view head = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
  return head;
}

/// Bounds the memory that an innocent-looking spec can request.
void check_size(const Shape& shape, const Values& values) {
  const auto proportion = [&](std::string_view across, std::string_view along) {
    const double squares = values.real(across) / values.real(along) * values.real("resolution") *
                           values.real("resolution");
    if (squares > 3e7) {
      throw Error("shape '" + std::string(shape.name) + "' would have some " +
                  std::to_string(static_cast<long long>(squares)) +
                  " vertices; lower the resolution or '" + std::string(across) + "'");
    }
  };
  if (shape.name == "plane") proportion("height", "width");
  if (shape.name == "cylinder") proportion("height", "radius");
  if (shape.name == "tube") proportion("length", "radius");
  if (shape.name == "sheets") proportion("height", "width");
}

struct AskedShape {
  const Shape& shape;
  Values values;
};

AskedShape parse_spec(std::string_view spec) {
  const Shape& shape = find_shape(take_until(spec, ','));
  Values values(shape.parameters);
  while (!spec.empty()) {
    std::string_view value = take_until(spec, ',');
    const std::string_view name = take_until(value, '=');
    const Parameter& parameter = find_parameter(shape, name);
    values.set(parameter.name, parse_value(shape, parameter, value));
  }
  check_size(shape, values);
  return {shape, values};
}

using Maker = std::function<Mesh(const Values&, const Progress&)>;

Mesh whole(const Maker& make, const Values& values, const Progress& progress) {
  return make(values, progress);
}
Mesh whole(const std::function<StripShape(const Values&)>& make, const Values& values,
           const Progress& progress) {
  return mesh_of(make(values), progress);
}

/// Suggests the resolution that fits into memory: vertices grow with its square.
[[noreturn]] void refuse_resolution(const AskedShape& asked, const TooLarge& error) {
  const double most = asked.values.real("resolution") * std::sqrt(error.share());
  throw TooLarge("shape '" + std::string(asked.shape.name) +
                     "': resolution=" + std::to_string(asked.values.whole("resolution")) +
                     " is too fine: " + error.what() +
                     ", as with resolution=" + std::to_string(static_cast<int>(std::floor(most))),
                 error.share());
}

}  // namespace

Mesh make_shape(std::string_view spec, const Progress& progress) {
  const AskedShape asked = parse_spec(spec);
  const Values& values = asked.values;
  const float noise = values.real("noise");
  std::vector<JobStage> parts = {{"shape", 5}};
  if (noise > 0) parts.push_back({"noise", 1});
  JobStages stages(progress, std::move(parts));
  try {
    const Progress making = stages.begin("shape");
    Mesh mesh =
        std::visit([&](const auto& make) { return whole(make, values, making); }, asked.shape.make);
    if (noise > 0) add_noise(mesh, noise, values.seed("noise_seed"), stages.begin("noise"));
    stages.finish();
    return mesh;
  } catch (const TooLarge& error) {
    refuse_resolution(asked, error);
  }
}

std::optional<ShapePart> make_shape_part(std::string_view spec, int part, int parts) {
  if (parts < 1) throw Error("a shape has one part or more, not " + std::to_string(parts));
  if (part < 0 || part >= parts) {
    throw Error("shape parts are numbered from 0 to " + std::to_string(parts - 1) +
                "; there is no part " + std::to_string(part));
  }
  const AskedShape asked = parse_spec(spec);
  const auto* strips = std::get_if<std::function<StripShape(const Values&)>>(&asked.shape.make);
  // Noise depends on the mean length of all edges.
  if (!strips || asked.values.real("noise") > 0) return std::nullopt;
  return part_of((*strips)(asked.values), part, parts);
}

std::vector<ShapeInfo> shape_catalogue() {
  std::vector<ShapeInfo> shapes;
  for (const Shape& shape : catalogue()) {
    shapes.push_back({std::string(shape.name), std::string(shape.help), shape.parameters});
  }
  return shapes;
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape& shape : catalogue()) names.emplace_back(shape.name);
  return names;
}

std::string shape_help() {
  std::string text;
  for (const Shape& shape : catalogue()) {
    text += std::string(shape.name) + ": " + std::string(shape.help) + '\n';
    for (const Parameter& parameter : shape.parameters) {
      text += "    " + parameter.name + formatted("=%g  ", parameter.standard) + parameter.help +
              " (" + range(parameter) + ")\n";
    }
  }
  return text;
}

}  // namespace brindle
