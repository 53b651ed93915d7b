/// Option rows: surfaces, fields and frequencies.
#pragma once

#include "brindle/option_table.h"
#include "brindle/pattern_of.h"
#include "brindle/recipe/row_words.h"

namespace brindle {

constexpr auto kSurfaceRows = in_group(
    {.group = "Surface", .stale = OptionStage::surface, .jobs = kAll},
    {{.name = "subdivide",
      .words = "split triangles",
      .kind = OptionKind::whole,
      .form = "K",
      .range = {.least = 0, .most = 10},
      .slider = {0, 4},
      .help = "split every triangle in four, K times; arrays of the file are interpolated"},
     {.name = "rounded",
      .words = "bend what is split",
      .kind = OptionKind::flag,
      .needs = "subdivide",
      .help =
          "--subdivide: bend triangles as the normals at their corners do, so that outlines of "
          "coarse meshes are round; edges where the surface bends by more than 40 degrees stay"},
     {.name = "crease-angle",
      .words = "creases from",
      .kind = OptionKind::number,
      .form = "DEG",
      .unit = "degrees",
      .standard = "40",
      .range = {.least = 0, .most = 180},
      .slider = {0, 180},
      .help = "bend from which an edge is a crease: its vertices have a wave for each side, so "
              "that stripes run straight on every face of a part (default 40; 180: none)"},
     {.name = "points",
      .words = "points alone",
      .kind = OptionKind::flag,
      .jobs = kStripe | kSample | kCompare,
      .help = "take the vertices alone, as points; files without faces (.vtp, .vtu, .vtk, .ply, "
              ".obj, .csv with rows x,y,z or x,y,z,nx,ny,nz, or with columns of these names) are "
              "points anyway"},
     {.name = "neighbors",
      .words = "neighbours",
      .kind = OptionKind::whole,
      .form = "K",
      .standard = "8",
      .range = {.least = 3, .most = 100},
      .slider = {3, 30},
      .jobs = kStripe | kSample | kCompare,
      .help = "points: join each to its K nearest (default 8)"},
     {.name = "up",
      .words = "axis that is up",
      .kind = OptionKind::choice,
      .form = "y|z",
      .stale = OptionStage::style,
      .jobs = kStripe | kCurves | kSample | kAnimate,
      .help = "the axis that points up in pictures (default z for shapes, y for files), and that "
              "'height' is measured along (default z)"}});

constexpr auto kFieldRows = in_group(
    {.group = "Field", .stale = OptionStage::field, .jobs = kAll},
    {{.name = "field",
      .words = "direction field",
      .kind = OptionKind::text,
      .form = "FILE|array:NAME|smooth|curvature|raw-curvature",
      .standard = "smooth",
      .file = true,
      .excludes = "direction",
      .help =
          "smooth (default); curvature, the smooth field drawn to principal curvature; "
          "raw-curvature, the latter alone; array:NAME, vectors or tensors that the mesh's file "
          "has per point or per cell (array:points/NAME, array:cells/NAME); or a CSV file with "
          "one row a vertex: x,y,z, x,y,z,frequency, x,y,z,frequency,frequency_v, or columns "
          "with names (FILE.csv:NAME if they hold several vectors)"},
     {.name = "cross",
      .words = "crosses",
      .kind = OptionKind::flag,
      .excludes = "frequency-v oriented stripes-v",
      .jobs = kStripe,
      .help = "a cross field: stripes along both waves of a cross, which change places from vertex "
              "to vertex where that is smoother; shown by a texture that looks the same turned by "
              "90 degrees (default checker)"},
     {.name = "direction",
      .words = "direction",
      .kind = OptionKind::text,
      .form = "X,Y,Z|AXIS",
      .excludes = "field",
      .jobs = kStripe | kCurves | kSample | kCompare,
      .help = "one vector for all vertices, or an axis such as x, projected into the tangent "
              "planes; stripes run across it"},
     {.name = "curvature-direction",
      .words = "principal direction",
      .kind = OptionKind::choice,
      .form = "max|min",
      .standard = "max",
      .help = "principal direction of the larger (default) or smaller curvature, for fields that "
              "follow it"},
     {.name = "curvature-anchor",
      .words = "drawn to curvature",
      .kind = OptionKind::number,
      .form = "W",
      .standard = "0",
      .range = kWeight,
      .slider = {0, 10, true},
      .help = "how strongly curvature attracts the smooth field (default 0: not; 0.1 with --field "
              "curvature)"},
     {.name = "feature-anchor",
      .words = "drawn to edges",
      .kind = OptionKind::number,
      .form = "W",
      .standard = "0",
      .range = kWeight,
      .slider = {0, 10, true},
      .help = "how strongly sharp edges and boundaries attract the smooth field, so that it runs "
              "along them (default 0: not)"},
     {.name = "feature-angle",
      .words = "sharp from",
      .kind = OptionKind::number,
      .form = "DEG",
      .unit = "degrees",
      .standard = "40",
      .range = kNotNegative,
      .slider = {0, 180},
      .help = "bend from which an edge is sharp for --feature-anchor (default 40)"},
     {.name = "feature-radius",
      .words = "reach of edges",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.1, 20, true},
      .help = "how far from edges and boundaries --feature-anchor attracts (default: at their "
              "vertices alone)"},
     {.name = "normal-radius",
      .words = "scale of bends",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.1, 20, true},
      .help =
          "the smooth field follows the bends of a surface whose normals are averaged over this "
          "distance: what is smaller makes no singularities (default: its own normals)"},
     {.name = "strokes",
      .words = "strokes of a file",
      .kind = OptionKind::text,
      .form = "FILE.json",
      .file = true,
      .help = "lines that the smooth field runs along, each with points, radius and strength"},
     {.name = "tensor",
      .words = "eigenvector",
      .kind = OptionKind::choice,
      .form = "major|minor|max-abs|tangent-major|tangent-minor",
      .standard = "major",
      .help =
          "--field array:NAME that is a symmetric tensor: along the eigenvector of the largest "
          "eigenvalue (default), the smallest, or the largest absolute one; tangent: of the part "
          "within the surface, as of stress at a free one"},
     {.name = "field-mesh",
      .words = "field of a mesh",
      .kind = OptionKind::text,
      .form = "FILE",
      .file = true,
      .stale = OptionStage::field | OptionStage::values,
      .help = "take arrays from this file, whose mesh or points may be finer or coarser: from the "
              "nearest place, or triangle"},
     {.name = "max-distance",
      .words = "farthest from it",
      .kind = OptionKind::length,
      .standard = "2%",
      .range = kNotNegative,
      .slider = {0.1, 50, true},
      .stale = OptionStage::field | OptionStage::values,
      .help = "--field-mesh: no wave farther away from it (default 2%)"},
     {.name = "field-detail",
      .words = "detail of the field",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .standard = "0",
      .range = {.least = 0, .most = 100},
      .slider = {0, 4},
      .stale = OptionStage::waves,
      .help =
          "smooth measured data over P periods of the stripes, and fill holes (default 0: use them "
          "as they are; 1 for noisy data)"},
     {.name = "field-weight",
      .words = "weight of the data",
      .kind = OptionKind::text,
      .form = "VALUE",
      .help = "--field-detail: how much every datum counts, 0 if it is none: "
              "array:NAME|FILE.csv[:COLUMN]|length|anisotropy, of vectors or tensors (default: "
              "tensors by their anisotropy, all others alike)"},
     {.name = "fill",
      .words = "fill holes",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .standard = "2",
      .range = kNotNegative,
      .slider = {0, 10},
      .stale = OptionStage::waves,
      .help = "--field-detail, --frequency-detail: how far holes in the data are filled; no wave "
              "farther away (default 2)"},
     {.name = "field-arrows",
      .words = "arrows, not lines",
      .kind = OptionKind::flag,
      .stale = OptionStage::field,
      .help =
          "--field-detail: vectors have a sign, and those that face each other cancel; without, "
          "they are lines"},
     {.name = "field-singularities",
      .words = "singularities left",
      .kind = OptionKind::whole,
      .form = "N",
      .range = {.least = 0, .most = 1000000},
      .slider = {0, 200},
      .stale = OptionStage::waves,
      .help = "--field-detail: cancel pairs of singularities, the nearest first, until at most N "
              "remain "
              "or no pair is left; elsewhere the field stays (default: keep all)"}});

constexpr auto kFieldOfFramesRows = in_group(
    {.group = "Field", .jobs = kAnimate},
    {{.name = "field-memory",
      .kind = OptionKind::number,
      .form = "M",
      .standard = "0",
      .range = kNotNegative,
      .slider = {0, 10},
      .help = "--field-detail: how much the field of the step before counts beside the data of a "
              "step, so "
              "that noise does not make it jump (default 0: not at all; 1: as much)"}});

constexpr auto kStripeRows = in_group(
    {.group = "Stripes", .stale = OptionStage::waves, .jobs = kAll},
    {{.name = "stripes",
      .words = "number of stripes",
      .kind = OptionKind::number,
      .form = "N",
      .unit = "stripes along the diagonal",
      .standard = "40",
      .range = kPositive,
      .slider = {2, 400, true},
      .excludes = "frequency spacing",
      .help = "stripes along the diagonal of the bounding box (default 40)"},
     {.name = "frequency",
      .words = "stripes per unit",
      .kind = OptionKind::number,
      .form = "F|array:NAME",
      .unit = "stripes per unit length",
      .range = kPositive,
      .slider = {0.01, 1000, true},
      .excludes = "stripes spacing",
      .help = "stripes per unit length, instead of --stripes, everywhere or in an array; all go "
              "before the frequencies of a field file"},
     {.name = "spacing",
      .words = "distance of stripes",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.25, 50, true},
      .excludes = "stripes frequency",
      .help = "distance between stripes along the surface"},
     {.name = "frequency-detail",
      .words = "detail of spacing",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .standard = "0",
      .range = {.least = 0, .most = 100},
      .slider = {0, 4},
      .help = "see frequencies of arrays and files at the scale of P periods of their stripes, "
              "without noise and with holes filled as far as --fill (default 0: as they are)"},
     {.name = "stripe-width",
      .words = "width of stripes",
      .kind = OptionKind::number,
      .form = "W",
      .unit = "share of the period",
      .standard = "0.5",
      .range = kShare,
      .slider = {0, 1},
      .stale = OptionStage::style,
      .jobs = kStripe | kAnimate,
      .help = "picture: share of the period (default 0.5)"},
     {.name = "rotate",
      .words = "turn",
      .kind = OptionKind::number,
      .form = "DEG",
      .unit = "degrees",
      .standard = "0",
      .range = kAnyNumber,
      .slider = {-180, 180},
      .help = "turn the field about the normals, in degrees"},
     {.name = "along",
      .words = "along the field",
      .kind = OptionKind::flag,
      .help = "stripes run along the field, not across it: waves are turned by 90 degrees"},
     {.name = "slack",
      .words = "spacing tolerance",
      .kind = OptionKind::number,
      .form = "S",
      .standard = "0",
      .range = kNotNegative,
      .slider = {0, 1},
      .stale = OptionStage::phases,
      .help =
          "let frequencies vary by a factor of up to 1 + S for fewer branches (default 0: not at "
          "all)"},
     {.name = "calm",
      .words = "avoid branches",
      .kind = OptionKind::text,
      .form = "FILE.csv",
      .file = true,
      .stale = OptionStage::phases,
      .help =
          "a CSV file of weights from 0 to 1, one a vertex: avoid branches there; needs --slack"},
     {.name = "frequency-by",
      .words = "denser where",
      .kind = OptionKind::text,
      .form = "VALUE",
      .by_camera = true,
      .help = "denser stripes where a value is larger (of vectors: longer): "
              "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|distance:camera|curvature|height|light"},
     {.name = "frequency-range",
      .words = "how dense",
      .kind = OptionKind::numbers,
      .form = "A,B[,inverse|reciprocal]",
      .standard = "0.4,2.5",
      .help =
          "--frequency-by: factors of --stripes where the value is smallest and largest (default "
          "0.4,2.5); inverse: the other way round; reciprocal: one over the value, from A to B"}});

constexpr auto kMakingRows = in_group(
    {.group = "Making", .stale = OptionStage::phases, .jobs = kStripe | kCurves},
    {{.name = "merge-branches",
      .words = "cancel branch pairs",
      .kind = OptionKind::number,
      .form = "SHARE",
      .range = kNotNegative,
      .slider = {0.001, 1, true},
      .help = "cancel pairs of opposite branches while the energy rises by at most SHARE (0.1: a "
              "tenth), for fewer branches"},
     {.name = "merge-distance",
      .words = "merge within",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .standard = "10",
      .range = {.least = 0, .most = 1000, .above_least = true},
      .slider = {1, 100, true},
      .help =
          "--merge-branches: how far the two branches of a pair may be from each other (default "
          "10)"},
     {.name = "anchor-boundary",
      .words = "start at boundaries",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .range = kAnyNumber,
      .slider = {0, 1},
      .help =
          "lay the first stripe along boundaries, P periods inside (0: on the rim; 0.5: the rim "
          "is in the middle of a gap)"},
     {.name = "winding",
      .words = "wind round loops",
      .kind = OptionKind::text,
      .form = "[LOOP:]K",
      .several = true,
      .help = "how many stripes wind round a loop as helices: 0 are rings, 1 a single spiral, -1 a "
              "left-handed one; turns the field by small angles. LOOP is a name of the report of "
              "'brindle curves', where there are several; repeatable"}});

constexpr auto kWaveRows =
    joined(kSurfaceRows, kFieldRows, kFieldOfFramesRows, kStripeRows, kMakingRows);

/// Calls `visit("--option", field)` for the numeric fabrication options.
template <class Visit>
void visit_making(MakingOptions& making, const Visit& visit) {
  visit("--anchor-boundary", making.anchor_boundary);
  visit("--merge-branches", making.merge_branches);
  visit("--merge-distance", making.merge_distance);
}

}  // namespace brindle
