#include "brindle/shapes.h"

#include <cmath>
#include <initializer_list>
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

/// A member of a shape's struct, and the function that finds it.
struct Member {
  float* real = nullptr;
  int* whole = nullptr;
  unsigned* seed = nullptr;  ///< one of the three
};
using FindMember = Member (*)(void* shape);

/// Shapes with a formula can be made in parts: they are strips.
using MakeWhole = Mesh (*)(std::span<const FindMember>, Values, const Progress&);
using MakeStrips = StripShape (*)(std::span<const FindMember>, Values);

struct Shape {
  std::string_view name;
  std::string_view help;
  std::vector<Parameter> parameters;  ///< those of members first
  std::vector<FindMember> members;
  std::variant<MakeWhole, MakeStrips> make;
};

void point_to(float& number, Member& member) { member.real = &number; }
void point_to(int& number, Member& member) { member.whole = &number; }
void point_to(unsigned& number, Member& member) { member.seed = &number; }

double value_of(const Member& member) {
  if (member.real != nullptr) return static_cast<double>(*member.real);
  return member.whole != nullptr ? *member.whole : static_cast<double>(*member.seed);
}

void set(const Member& member, double value) {
  if (member.real != nullptr) *member.real = static_cast<float>(value);
  if (member.whole != nullptr) *member.whole = static_cast<int>(value);
  if (member.seed != nullptr) *member.seed = static_cast<unsigned>(value);
}

/// A parameter that sets a member of a shape's struct, which has its default.
struct AnyField {
  std::string_view name;
  FindMember member;
  double lower, upper;
  std::string_view help;
};
/// The struct is part of the type, so that the field of another one does not compile.
template <class Struct>
struct Field : AnyField {};

template <class Member>
struct StructOf;
template <class Struct, class Number>
struct StructOf<Number Struct::*> {
  using Type = Struct;
};

template <auto kMember>
auto field(std::string_view name, double lower, double upper, std::string_view help) {
  using Struct = typename StructOf<decltype(kMember)>::Type;
  const FindMember find = [](void* shape) {
    Member member;
    point_to(static_cast<Struct*>(shape)->*kMember, member);
    return member;
  };
  return Field<Struct>{{name, find, lower, upper, help}};
}

template <auto kMember>
auto length(std::string_view name, std::string_view help) {
  return field<kMember>(name, 1e-3, 1e3, help);
}

template <class Struct>
Field<Struct> resolution(double lower, double upper, std::string_view help) {
  return field<&Struct::resolution>("resolution", lower, upper, help);
}

constexpr double kLargestSeed = 4294967295;
constexpr std::string_view kSeedHelp = "another one, another shape";

void add(const AnyField& field, void* standard, Shape& shape) {
  const Member member = field.member(standard);
  const bool whole = member.real == nullptr;
  shape.parameters.push_back({std::string(field.name), value_of(member), field.lower, field.upper,
                              whole, std::string(field.help)});
  shape.members.push_back(field.member);
}

void add_noise_to(Shape& shape) {
  shape.parameters.push_back(
      {"noise", 0, 0, 10, false, "displacement of vertices, in mean edge lengths"});
  shape.parameters.push_back({"noise_seed", 1, 0, kLargestSeed, true, std::string(kSeedHelp)});
}

void fill(void* shape, std::span<const FindMember> members, Values values) {
  for (std::size_t i = 0; i < members.size(); ++i) set(members[i](shape), values[i]);
}

template <class Made, class Struct, class... Heard>
Struct struct_of(Made (*make)(const Struct&, const Heard&...));

/// `kMake` takes the shape's struct, and the progress unless it makes strips.
template <auto kMake, class Struct = decltype(struct_of(kMake))>
Shape shape_of(std::string_view name, std::string_view help,
               std::initializer_list<Field<Struct>> fields) {
  Shape shape{name, help, {}, {}, {}};
  Struct standard;
  for (const Field<Struct>& field : fields) add(field, &standard, shape);
  add_noise_to(shape);
  const auto make = [](std::span<const FindMember> members, Values values, const auto&... heard) {
    Struct made;
    fill(&made, members, values);
    return kMake(made, heard...);
  };
  if constexpr (std::is_invocable_v<decltype(kMake), const Struct&>) {
    shape.make = MakeStrips(make);
  } else {
    shape.make = MakeWhole(make);
  }
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
      shape_of<plane_strips>("plane", "a rectangle",
                             {length<&PlaneShape::width>("width", "along x"),
                              length<&PlaneShape::height>("height", "along y"),
                              resolution<PlaneShape>(1, 5000, "edges along x")}),
      shape_of<cylinder_strips>("cylinder", "the open side surface of a cylinder",
                                {length<&CylinderShape::radius>("radius", "radius"),
                                 length<&CylinderShape::height>("height", "along z"),
                                 resolution<CylinderShape>(3, 10000, "edges around")}),
      shape_of<checked_tube>(
          "tube", "an open tube along an arc: a sleeve, a vase",
          {length<&TubeShape::radius>("radius", "radius"),
           length<&TubeShape::length>("length", "along the arc"),
           field<&TubeShape::bend_deg>("bend", 0, 360, "how much the arc turns, in degrees"),
           field<&TubeShape::bulge>("bulge", 0, 0.9, "wider by this share below, narrower above"),
           field<&TubeShape::taper>("taper", 0.1, 10,
                                    "radius of the upper end over that of the lower"),
           resolution<TubeShape>(3, 5000, "edges around")}),
      shape_of<sphere_strips>(
          "sphere", "a divided icosahedron",
          {length<&SphereShape::radius>("radius", "radius"),
           resolution<SphereShape>(1, 1500, "edges along an edge of the icosahedron")}),
      shape_of<checked_torus>(
          "torus", "a ring",
          {length<&TorusShape::major>("major", "radius of the ring"),
           length<&TorusShape::minor>("minor", "radius of the tube, below major"),
           resolution<TorusShape>(4, 10000, "edges along the ring")}),
      shape_of<trefoil_strips>(
          "trefoil", "a tube along a trefoil knot",
          {field<&TrefoilShape::radius>("radius", 0.01, 0.25, "radius of the tube"),
           resolution<TrefoilShape>(3, 500, "edges around the tube")}),
  };
}

std::vector<Shape> solid_shapes() {
  return {
      shape_of<make_vessels>(
          "vessels", "a branching tree of vessels",
          {field<&VesselsShape::generations>("generations", 0, 7, "splits of the trunk"),
           field<&VesselsShape::radius>("radius", 0.03, 0.3,
                                        "radius of the trunk, before scaling to size 2"),
           field<&VesselsShape::spread>("spread", 0.1, 1.3, "angle of the branches, radians"),
           field<&VesselsShape::seed>("seed", 0, kLargestSeed, kSeedHelp),
           resolution<VesselsShape>(20, 800, "edges along one unit")}),
      shape_of<make_molecule>(
          "molecule", "blended spheres",
          {field<&MoleculeShape::atoms>("atoms", 1, 200, "number of spheres"),
           field<&MoleculeShape::blend>("blend", 0.001, 0.3, "radius of the blends"),
           field<&MoleculeShape::seed>("seed", 0, kLargestSeed, kSeedHelp),
           resolution<MoleculeShape>(5, 800, "edges along one unit")}),
      shape_of<checked_box>(
          "box", "a block with rounded edges and a hole",
          {field<&BoxShape::width>("width", 0.1, 10, "along x"),
           field<&BoxShape::depth>("depth", 0.1, 10, "along y"),
           field<&BoxShape::height>("height", 0.1, 10, "along z"),
           field<&BoxShape::fillet>("fillet", 0.001, 5, "radius of the rounding"),
           field<&BoxShape::hole>("hole", 0, 5, "radius of the hole along z; 0 for none"),
           resolution<BoxShape>(5, 400, "edges along one unit")}),
      shape_of<checked_bracket>(
          "bracket",
          "two plates at right angles with holes and a fillet, flat and coarse as from CAD",
          {field<&BracketShape::length>("length", 0.1, 10, "along x"),
           field<&BracketShape::depth>("depth", 0.1, 10, "along y"),
           field<&BracketShape::height>("height", 0.1, 10, "along z"),
           field<&BracketShape::thickness>("thickness", 0.01, 5, "of the plates"),
           field<&BracketShape::fillet>("fillet", 0.01, 5, "radius between the plates"),
           field<&BracketShape::hole>("hole", 0.01, 5, "radius of the holes"),
           resolution<BracketShape>(1, 200, "edges along a quarter of a circle")}),
      shape_of<checked_gear>(
          "gear", "a gear with a bore, flat and coarse as from CAD",
          {field<&GearShape::teeth>("teeth", 3, 200, "number of teeth"),
           field<&GearShape::radius>("radius", 0.1, 10, "to the tips of the teeth"),
           field<&GearShape::tooth>("tooth", 0.001, 5, "height of a tooth"),
           field<&GearShape::width>("width", 0.01, 10, "along z"),
           field<&GearShape::bore>("bore", 0.01, 8, "radius of the bore"),
           resolution<GearShape>(2, 20, "edges of the bore for each tooth")}),
  };
}

/// Shapes with borders, one side, edges of many triangles or several components.
std::vector<Shape> special_shapes() {
  return {
      shape_of<hemisphere_strips>("hemisphere", "half a sphere, open below",
                                  {length<&HemisphereShape::radius>("radius", "radius"),
                                   resolution<HemisphereShape>(1, 3000, "edges from pole to rim")}),
      shape_of<checked_mobius>(
          "mobius", "a strip with half a turn, its ends joined: unorientable",
          {length<&MobiusShape::radius>("radius", "radius of the middle line"),
           length<&MobiusShape::width>("width", "width of the strip, below 2 radius"),
           resolution<MobiusShape>(1, 2000, "edges across the strip")}),
      shape_of<sheets_strips>("sheets", "sheets that meet in one edge: not a manifold",
                              {field<&SheetsShape::count>("count", 1, 32, "number of sheets"),
                               length<&SheetsShape::width>("width", "of a sheet"),
                               length<&SheetsShape::height>("height", "along z"),
                               resolution<SheetsShape>(1, 1000, "edges along the width")}),
      shape_of<pieces_strips>(
          "pieces", "unconnected spheres, rings and cylinders",
          {field<&PiecesShape::count>("count", 1, 100, "number of pieces"),
           resolution<PiecesShape>(2, 300, "edges along an edge of the icosahedron")}),
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
    Mesh mesh =
        strips ? mesh_of((*strips)(asked.shape.members, asked.values), making)
               : std::get<MakeWhole>(asked.shape.make)(asked.shape.members, asked.values, making);
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
  return part_of((*strips)(asked.shape.members, asked.values), part, parts);
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
