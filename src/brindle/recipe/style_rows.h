/// Option rows: colours by value, outlines and depth cues.
#pragma once

#include "brindle/option_table.h"
#include "brindle/recipe/row_words.h"

namespace brindle {

constexpr auto kColorRows = in_group(
    {.group = "Colours by value",
     .stale = OptionStage::style,
     .jobs = kStripe | kSample | kAnimate},
    {{.name = "color-by",
      .words = "colour by",
      .kind = OptionKind::text,
      .form = "VALUE",
      .by_camera = true,
      .own = true,
      .stale = OptionStage::style | OptionStage::values,
      .help = "picture: colours by a value: "
              "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|distance:camera|curvature|height|"
              "light|agreement"},
     {.name = "color-range",
      .words = "from and to",
      .kind = OptionKind::numbers,
      .form = "A,B",
      .own = true,
      .stale = OptionStage::style | OptionStage::margin,
      .help = "--color-by: values at the ends of the map (default: all)"},
     {.name = "colormap",
      .words = "colour map",
      .kind = OptionKind::choice,
      .form = "viridis|magma|cividis|coolwarm",
      .standard = "viridis",
      .own = true,
      .help = "--color-by: the map (default viridis)"},
     {.name = "color-on",
      .words = "what is coloured",
      .kind = OptionKind::choice,
      .form = "strokes|surface|figures",
      .jobs = kStripe | kAnimate,
      .help = "--color-by: what is coloured (default strokes; with --texture the surface, or "
              "figures of tiles)"},
     {.name = "threshold",
      .words = "stands out from",
      .kind = OptionKind::number,
      .form = "T",
      .range = kAnyNumber,
      .slider = {0, 1},
      .own = true,
      .help = "--color-by: from this value on one colour that stands out"},
     {.name = "opacity-by",
      .words = "opacity by",
      .kind = OptionKind::text,
      .form = "VALUE",
      .by_camera = true,
      .stale = OptionStage::style | OptionStage::values,
      .jobs = kStripe | kAnimate,
      .help = "picture: more opaque stripes where the value is larger"},
     {.name = "opacity-range",
      .words = "how opaque",
      .kind = OptionKind::numbers,
      .form = "A,B",
      .standard = "0,1",
      .jobs = kStripe | kAnimate,
      .help = "--opacity-by: where the value is smallest and largest (default 0,1)"},
     {.name = "legend",
      .words = "text of the legend",
      .kind = OptionKind::text,
      .form = "TEXT",
      .own = true,
      .stale = OptionStage::style | OptionStage::margin,
      .help = "the legend's title (default: the value's name), such as 'speed in m/s'"},
     {.name = "no-legend",
      .words = "no legend",
      .kind = OptionKind::flag,
      .own = true,
      .stale = OptionStage::style | OptionStage::margin,
      .help = "no legend of widths and colours"}});

constexpr auto kOutlineRows = in_group(
    {.group = "Outlines and depth", .stale = OptionStage::style, .jobs = kStripe | kAnimate},
    {{.name = "outline",
      .words = "outlines",
      .kind = OptionKind::choice,
      .form = "none|solid|dashed",
      .standard = "none",
      .help = "picture: silhouettes; dashed: with dashes where the pattern has stripes"},
     {.name = "creases",
      .words = "lines at creases",
      .kind = OptionKind::number,
      .form = "DEG",
      .unit = "degrees",
      .range = {.least = 0, .most = 180, .above_least = true, .below_most = true},
      .slider = {0, 180},
      .help = "picture: lines along borders and edges that bend by more than this"},
     {.name = "hidden-lines",
      .words = "hidden lines",
      .kind = OptionKind::choice,
      .form = "none|dashed",
      .standard = "none",
      .help = "--outline, --creases: left out (default), or thin and dashed"},
     {.name = "line-width",
      .words = "width of lines",
      .kind = OptionKind::number,
      .form = "PIXELS",
      .unit = "pixels",
      .range = kPixels,
      .slider = {0.5, 20, true},
      .help = "--outline, --creases: how wide (default: 0.25 % of the picture's height)"}});

constexpr auto kDrawingRows = in_group(
    {.group = "Outlines and depth", .jobs = kStripe},
    {{.name = "min-area",
      .kind = OptionKind::number,
      .form = "A",
      .unit = "square pixels",
      .standard = "0.1",
      .range = {.least = 0},
      .help = "drawings: areas smaller than A square pixels are left out (default: 0.1)"}});

constexpr auto kDepthRows = in_group(
    {.group = "Outlines and depth", .stale = OptionStage::style, .jobs = kStripe | kAnimate},
    {{.name = "occlusion",
      .words = "dark hollows",
      .kind = OptionKind::number,
      .form = "A",
      .standard = "0",
      .range = kShare,
      .slider = {0, 1},
      .help = "picture: how dark hollows and creases are, 0 (default) to 1"},
     {.name = "ground-shadow",
      .words = "ground shadow",
      .kind = OptionKind::flag,
      .help = "picture: a soft shadow on the ground"},
     {.name = "depth-cue",
      .words = "fade with depth",
      .kind = OptionKind::choice,
      .form = "none|chroma|haze",
      .standard = "none",
      .help = "picture: near is red and far is blue, or what is far fades"},
     {.name = "transparent",
      .words = "no background",
      .kind = OptionKind::flag,
      .help = "picture: no background"},
     {.name = "with",
      .words = "other surfaces",
      .kind = OptionKind::text,
      .form = "MESH",
      .several = true,
      .files = kMeshFiles,
      .help =
          "picture: another surface, plain unless it says more: "
          "MESH[@opaque|striped|discarded][@texture=TILE][@stripes=N][@rotate=DEG]"
          "[@stripe-width=W][@stripe-color=#rrggbb][@color-by=VALUE][@outlined][@untinted]"
          "[@whole][@#rrggbb][@X,Y,Z], VALUE: of MESH, as --color-by has them, outlined: without "
          "--outline, untinted: without --depth-cue, whole: in spite of --slice, moved by X,Y,Z; "
          "repeatable"}});

constexpr auto kStyleRows = joined(kColorRows, kOutlineRows, kDrawingRows, kDepthRows);

}  // namespace brindle
