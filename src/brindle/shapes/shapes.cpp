#include "brindle/shapes.h"

#include <cmath>
#include <functional>
#include <span>
#include <type_traits>
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

/// The values of all parameters, in their order.
using Values = std::span<const double>;
using MakeWhole = std::function<Mesh(Values, const Progress&)>;
using MakeStrips = std::function<StripShape(Values)>;

struct Shape {
  std::string_view name;
  std::string_view help;
  std::vector<Parameter> parameters;
  std::variant<MakeWhole, MakeStrips> make;  ///< shapes with a formula can be made in parts
};

/// A parameter that sets a member of a shape's struct, which has its default.
template <class Struct>
struct Field {
  Parameter parameter;
  std::function<void(Struct&, double)> set;
};

template <class Struct, class Number>
Field<Struct> field(std::string_view name, Number Struct::*member, double lower, double upper,
                    std::string_view help) {
  return {{std::string(name), static_cast<double>(Struct().*member), lower, upper,
           std::is_integral_v<Number>, std::string(help)},
          [member](Struct& shape, double value) { shape.*member = static_cast<Number>(value); }};
}

template <class Struct>
Field<Struct> length(std::string_view name, float Struct::*member, std::string_view help) {
  return field(name, member, 1e-3, 1e3, help);
}

template <class Struct>
Field<Struct> resolution(int lower, int upper, std::string_view help) {
  return field("resolution", &Struct::resolution, lower, upper, help);
}

constexpr double kLargestSeed = 4294967295;
constexpr std::string_view kSeedHelp = "another one, another shape";

/// `make` takes the shape's struct, and the progress unless it makes strips.
template <class Struct, class Made, class... Heard>
Shape shape_of(std::string_view name, std::string_view help,
               const std::vector<Field<Struct>>& fields,
               Made (*make)(const Struct&, const Heard&...)) {
  Shape shape{name, help, {}, {}};
  for (const Field<Struct>& field : fields) shape.parameters.push_back(field.parameter);
  shape.parameters.push_back(
      {"noise", 0, 0, 10, false, "displacement of vertices, in mean edge lengths"});
  shape.parameters.push_back({"noise_seed", 1, 0, kLargestSeed, true, std::string(kSeedHelp)});
  shape.make = std::function<Made(Values, const Heard&...)>(
      [fields, make](Values values, const Heard&... heard) {
        Struct made;
        for (std::size_t i = 0; i < fields.size(); ++i) fields[i].set(made, values[i]);
        return make(made, heard...);
      });
  return shape;
}

StripShape checked_tube(const TubeShape& shape) {
  const double widest =
      static_cast<double>(shape.radius) * (1 + shape.bulge) * std::max(1.0f, shape.taper);
  if (widest * static_cast<double>(shape.bend_deg) * 0.0174533 >= shape.length) {
    throw Error(
        "shape 'tube': it would cut into itself; lower bend, radius, bulge or taper, or raise "
        "length");
  }
  return tube_strips(shape);
}

StripShape checked_torus(const TorusShape& shape) {
  if (shape.minor >= 0.999f * shape.major) {
    throw Error("shape 'torus': minor must be below major; make one of them smaller or larger");
  }
  return torus_strips(shape);
}

StripShape checked_mobius(const MobiusShape& shape) {
  if (shape.width >= 2 * shape.radius) {
    throw Error("shape 'mobius': width must be below twice the radius");
  }
  if (shape.radius / shape.width * static_cast<float>(shape.resolution) > 2000) {
    throw Error("shape 'mobius': too many triangles; lower the resolution or the radius");
  }
  return mobius_strips(shape);
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

Mesh checked_bracket(const BracketShape& shape, const Progress& /*progress*/) {
  if (!(shape.hole < room_for_hole(shape))) {
    throw Error(
        "shape 'bracket': the holes do not fit; hole must be below half of depth, and of what "
        "thickness and fillet leave of length and height");
  }
  return make_bracket(shape);
}

Mesh checked_gear(const GearShape& shape, const Progress& /*progress*/) {
  if (shape.tooth > shape.radius / 2) {
    throw Error("shape 'gear': tooth must be at most half of radius");
  }
  if (shape.bore > 0.8f * (shape.radius - shape.tooth)) {
    throw Error("shape 'gear': bore must be at most 0.8 of what tooth leaves of radius");
  }
  return make_gear(shape);
}

std::vector<Shape> open_and_closed_shapes() {
  return {
      shape_of("plane", "a rectangle",
               {length("width", &PlaneShape::width, "along x"),
                length("height", &PlaneShape::height, "along y"),
                resolution<PlaneShape>(1, 5000, "edges along x")},
               plane_strips),
      shape_of("cylinder", "the open side surface of a cylinder",
               {length("radius", &CylinderShape::radius, "radius"),
                length("height", &CylinderShape::height, "along z"),
                resolution<CylinderShape>(3, 10000, "edges around")},
               cylinder_strips),
      shape_of(
          "tube", "an open tube along an arc: a sleeve, a vase",
          {length("radius", &TubeShape::radius, "radius"),
           length("length", &TubeShape::length, "along the arc"),
           field("bend", &TubeShape::bend_deg, 0, 360, "how much the arc turns, in degrees"),
           field("bulge", &TubeShape::bulge, 0, 0.9, "wider by this share below, narrower above"),
           field("taper", &TubeShape::taper, 0.1, 10,
                 "radius of the upper end over that of the lower"),
           resolution<TubeShape>(3, 5000, "edges around")},
          checked_tube),
      shape_of("sphere", "a divided icosahedron",
               {length("radius", &SphereShape::radius, "radius"),
                resolution<SphereShape>(1, 1500, "edges along an edge of the icosahedron")},
               sphere_strips),
      shape_of("torus", "a ring",
               {length("major", &TorusShape::major, "radius of the ring"),
                length("minor", &TorusShape::minor, "radius of the tube, below major"),
                resolution<TorusShape>(4, 10000, "edges along the ring")},
               checked_torus),
      shape_of("trefoil", "a tube along a trefoil knot",
               {field("radius", &TrefoilShape::radius, 0.01, 0.25, "radius of the tube"),
                resolution<TrefoilShape>(3, 500, "edges around the tube")},
               trefoil_strips),
  };
}

std::vector<Shape> solid_shapes() {
  return {
      shape_of("vessels", "a branching tree of vessels",
               {field("generations", &VesselsShape::generations, 0, 7, "splits of the trunk"),
                field("radius", &VesselsShape::radius, 0.03, 0.3,
                      "radius of the trunk, before scaling to size 2"),
                field("spread", &VesselsShape::spread, 0.1, 1.3, "angle of the branches, radians"),
                field("seed", &VesselsShape::seed, 0, kLargestSeed, kSeedHelp),
                resolution<VesselsShape>(20, 800, "edges along one unit")},
               make_vessels),
      shape_of("molecule", "blended spheres",
               {field("atoms", &MoleculeShape::atoms, 1, 200, "number of spheres"),
                field("blend", &MoleculeShape::blend, 0.001, 0.3, "radius of the blends"),
                field("seed", &MoleculeShape::seed, 0, kLargestSeed, kSeedHelp),
                resolution<MoleculeShape>(5, 800, "edges along one unit")},
               make_molecule),
      shape_of("box", "a block with rounded edges and a hole",
               {field("width", &BoxShape::width, 0.1, 10, "along x"),
                field("depth", &BoxShape::depth, 0.1, 10, "along y"),
                field("height", &BoxShape::height, 0.1, 10, "along z"),
                field("fillet", &BoxShape::fillet, 0.001, 5, "radius of the rounding"),
                field("hole", &BoxShape::hole, 0, 5, "radius of the hole along z; 0 for none"),
                resolution<BoxShape>(5, 400, "edges along one unit")},
               checked_box),
      shape_of("bracket",
               "two plates at right angles with holes and a fillet, flat and coarse as from CAD",
               {field("length", &BracketShape::length, 0.1, 10, "along x"),
                field("depth", &BracketShape::depth, 0.1, 10, "along y"),
                field("height", &BracketShape::height, 0.1, 10, "along z"),
                field("thickness", &BracketShape::thickness, 0.01, 5, "of the plates"),
                field("fillet", &BracketShape::fillet, 0.01, 5, "radius between the plates"),
                field("hole", &BracketShape::hole, 0.01, 5, "radius of the holes"),
                resolution<BracketShape>(1, 200, "edges along a quarter of a circle")},
               checked_bracket),
      shape_of("gear", "a gear with a bore, flat and coarse as from CAD",
               {field("teeth", &GearShape::teeth, 3, 200, "number of teeth"),
                field("radius", &GearShape::radius, 0.1, 10, "to the tips of the teeth"),
                field("tooth", &GearShape::tooth, 0.001, 5, "height of a tooth"),
                field("width", &GearShape::width, 0.01, 10, "along z"),
                field("bore", &GearShape::bore, 0.01, 8, "radius of the bore"),
                resolution<GearShape>(2, 20, "edges of the bore for each tooth")},
               checked_gear),
  };
}

/// Shapes with borders, one side, edges of many triangles or several components.
std::vector<Shape> special_shapes() {
  return {
      shape_of("hemisphere", "half a sphere, open below",
               {length("radius", &HemisphereShape::radius, "radius"),
                resolution<HemisphereShape>(1, 3000, "edges from pole to rim")},
               hemisphere_strips),
      shape_of("mobius", "a strip with half a turn, its ends joined: unorientable",
               {length("radius", &MobiusShape::radius, "radius of the middle line"),
                length("width", &MobiusShape::width, "width of the strip, below 2 radius"),
                resolution<MobiusShape>(1, 2000, "edges across the strip")},
               checked_mobius),
      shape_of("sheets", "sheets that meet in one edge: not a manifold",
               {field("count", &SheetsShape::count, 1, 32, "number of sheets"),
                length("width", &SheetsShape::width, "of a sheet"),
                length("height", &SheetsShape::height, "along z"),
                resolution<SheetsShape>(1, 1000, "edges along the width")},
               sheets_strips),
      shape_of("pieces", "unconnected spheres, rings and cylinders",
               {field("count", &PiecesShape::count, 1, 100, "number of pieces"),
                resolution<PiecesShape>(2, 300, "edges along an edge of the icosahedron")},
               pieces_strips),
  };
}

const std::vector<Shape>& catalogue() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = open_and_closed_shapes();
    for (const auto& more : {solid_shapes(), special_shapes()}) {
      all.insert(all.end(), more.begin(), more.end());
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

struct AskedShape {
  const Shape& shape;
  std::vector<double> values;  ///< of all parameters

  double& value(std::string_view name) {
    return values[static_cast<std::size_t>(&find_parameter(shape, name) - shape.parameters.data())];
  }
  float real(std::string_view name) { return static_cast<float>(value(name)); }
};

/// Bounds the memory that an innocent-looking spec can request.
void check_size(AskedShape& asked) {
  const std::string_view name = asked.shape.name;
  const auto proportion = [&](std::string_view across, std::string_view along) {
    const double squares = asked.real(across) / asked.real(along) * asked.real("resolution") *
                           asked.real("resolution");
    if (squares > 3e7) {
      throw Error("shape '" + std::string(name) + "' would have some " +
                  std::to_string(static_cast<long long>(squares)) +
                  " vertices; lower the resolution or '" + std::string(across) + "'");
    }
  };
  if (name == "plane") proportion("height", "width");
  if (name == "cylinder") proportion("height", "radius");
  if (name == "tube") proportion("length", "radius");
  if (name == "sheets") proportion("height", "width");
}

AskedShape parse_spec(std::string_view spec) {
  AskedShape asked{find_shape(take_until(spec, ',')), {}};
  for (const Parameter& p : asked.shape.parameters) asked.values.push_back(p.standard);
  while (!spec.empty()) {
    std::string_view value = take_until(spec, ',');
    const Parameter& parameter = find_parameter(asked.shape, take_until(value, '='));
    asked.value(parameter.name) = parse_value(asked.shape, parameter, value);
  }
  check_size(asked);
  return asked;
}

/// Suggests the resolution that fits into memory: vertices grow with its square.
[[noreturn]] void refuse_resolution(AskedShape& asked, const TooLarge& error) {
  const double most = asked.value("resolution") * std::sqrt(error.share());
  throw TooLarge("shape '" + std::string(asked.shape.name) + "': resolution=" +
                     std::to_string(static_cast<int>(asked.value("resolution"))) +
                     " is too fine: " + error.what() +
                     ", as with resolution=" + std::to_string(static_cast<int>(std::floor(most))),
                 error.share());
}

}  // namespace

Mesh make_shape(std::string_view spec, const Progress& progress) {
  AskedShape asked = parse_spec(spec);
  const float noise = asked.real("noise");
  std::vector<JobStage> parts = {{"shape", 5}};
  if (noise > 0) parts.push_back({"noise", 1});
  JobStages stages(progress, std::move(parts));
  try {
    const Progress making = stages.begin("shape");
    const auto* strips = std::get_if<MakeStrips>(&asked.shape.make);
    Mesh mesh = strips ? mesh_of((*strips)(asked.values), making)
                       : std::get<MakeWhole>(asked.shape.make)(asked.values, making);
    const auto seed = static_cast<std::uint32_t>(asked.value("noise_seed"));
    if (noise > 0) add_noise(mesh, noise, seed, stages.begin("noise"));
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
  AskedShape asked = parse_spec(spec);
  const auto* strips = std::get_if<MakeStrips>(&asked.shape.make);
  // Noise depends on the mean length of all edges.
  if (!strips || asked.real("noise") > 0) return std::nullopt;
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
