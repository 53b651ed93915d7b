/// Option rows: curves and samples.
#pragma once

#include "brindle/curves.h"
#include "brindle/option_table.h"
#include "brindle/recipe/row_words.h"

namespace brindle {

constexpr auto kCurveRows = in_group(
    {.group = "Curves", .own = true, .stale = OptionStage::style, .jobs = kCurves},
    {{.name = "lines",
      .words = "curves of",
      .kind = OptionKind::choice,
      .form = "u|v|both",
      .standard = "u",
      .help = "across the field (u, default), along it (v: stripes of the field turned by 90 "
              "degrees), or both"},
     {.name = "offset",
      .words = "move by periods",
      .kind = OptionKind::number,
      .form = "P",
      .unit = "periods",
      .standard = "0",
      .range = kAnyNumber,
      .slider = {-0.5, 0.5},
      .help = "in periods from the stripes' centres (default 0; 0.5: centres of the gaps)"},
     {.name = "join",
      .words = "join ends",
      .kind = OptionKind::flag,
      .excludes = "trim",
      .help =
          "join curves that end in the same triangle in pairs, and let others run on into their "
          "neighbours"},
     {.name = "trim",
      .words = "trim ends",
      .kind = OptionKind::number,
      .form = "SHARE",
      .unit = "of the spacing",
      .standard = "0.6",
      .range = {.least = 0, .most = 1},
      .slider = {0, 1},
      .excludes = "join",
      .help = "keep SHARE of the spacing free beside ends (default 0.6; 0: as traced)"},
     {.name = "fair",
      .words = "fair curves",
      .kind = OptionKind::number,
      .form = "SHARE",
      .unit = "of the spacing",
      .standard = "0",
      .range = {.least = 0, .most = 1},
      .slider = {0, 1},
      .help =
          "take out kinks shorter than about SHARE of the spacing, on the surface (default 0: as "
          "traced; 0.25 is good); ends that --join lets run on then meet their neighbours with no "
          "angle where they can"},
     {.name = "min-length",
      .words = "shortest curve",
      .kind = OptionKind::length,
      .range = kNotNegative,
      .slider = {0, 50},
      .help = "leave out shorter curves"},
     {.name = "simplify",
      .words = "simplify",
      .kind = OptionKind::length,
      .range = kNotNegative,
      .slider = {0, 1},
      .help = "leave out points up to this far from the curve"},
     {.name = "resample",
      .words = "points apart",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.1, 5, true},
      .help = "points at equal distances, about this far apart; --simplify then leaves out some of "
              "them"},
     {.name = "line-width",
      .words = "width to measure",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.05, 5, true},
      .help = "report how much of the surface lines of this width cover"},
     {.name = "stripes-v",
      .words = "stripes across",
      .kind = OptionKind::number,
      .form = "N",
      .unit = "stripes along the diagonal",
      .range = kPositive,
      .slider = {2, 400, true, true},
      .excludes = "frequency-v",
      .stale = OptionStage::style | OptionStage::second,
      .jobs = kCurves | kSample,
      .help = "V: as --stripes (default: frequency_v of --field's file, or U's frequencies)"},
     {.name = "frequency-v",
      .words = "across, per unit",
      .kind = OptionKind::number,
      .form = "F",
      .unit = "stripes per unit length",
      .range = kPositive,
      .slider = {0.01, 1000, true},
      .excludes = "stripes-v",
      .stale = OptionStage::style | OptionStage::second,
      .jobs = kCurves | kSample,
      .help = "V: as --frequency; either goes before the frequencies of a file"},
     {.name = "field-v",
      .words = "field across",
      .kind = OptionKind::text,
      .form = "FILE",
      .files = ".csv",
      .stale = OptionStage::style | OptionStage::second,
      .jobs = kCurves | kSample,
      .help = "V: a CSV file of rows x,y,z or x,y,z,frequency (default: U's field turned by 90 "
              "degrees)"},
     {.name = "wales",
      .words = "wales",
      .kind = OptionKind::whole,
      .form = "[LOOP:]N",
      .unit = "stripes round the surface",
      .range = {.least = 1},
      .slider = {1, 400, true},
      .stale = OptionStage::style | OptionStage::second,
      .help = "V: exactly N stripes round a surface with one way round, as the wales of a sleeve; "
              "LOOP:N round one of several, by its name in the report"},
     {.name = "tube-radius",
      .words = "radius of tubes",
      .kind = OptionKind::length,
      .range = kPositive,
      .slider = {0.02, 3, true},
      .help = "write mesh files of tubes, not lines (pictures show tubes anyway)"},
     {.name = "tube-sides",
      .words = "sides of tubes",
      .kind = OptionKind::whole,
      .form = "N",
      .standard = "8",
      .range = {.least = 3, .most = 64},
      .slider = {3, 64},
      .help = "3 to 64 (default 8)"}});

constexpr auto kSampleRows = in_group(
    {.group = "Samples", .own = true, .stale = OptionStage::style, .jobs = kSample},
    {{.name = "glyph",
      .words = "glyph",
      .kind = OptionKind::text,
      .form = "disc|arrow|ellipse|stroke|FILE.png",
      .files = ".png",
      .help = "picture: what stands at samples: discs (default), arrows along the field, ellipses "
              "whose axes are the spacings, strokes of a brush, or a picture with transparency, "
              "which lies flat and may cross the silhouette"},
     {.name = "glyph-size",
      .words = "size of glyphs",
      .kind = OptionKind::number,
      .form = "S",
      .unit = "spacings",
      .standard = "0.8",
      .range = kPositive,
      .slider = {0.1, 2, true},
      .help = "picture: share of the spacing (default 0.8)"},
     {.name = "size-by",
      .words = "larger where",
      .kind = OptionKind::text,
      .form = "VALUE",
      .by_camera = true,
      .help = "picture: larger glyphs where a value is larger: "
              "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|distance:camera|curvature|height|"
              "light|agreement"},
     {.name = "size-range",
      .words = "how large",
      .kind = OptionKind::numbers,
      .form = "A,B",
      .standard = "0.25,1",
      .help = "--size-by: shares of --glyph-size at the smallest value and the largest (default "
              "0.25,1)"},
     {.name = "min-distance",
      .words = "smallest distance",
      .kind = OptionKind::number,
      .form = "D",
      .unit = "spacings",
      .standard = "0.25",
      .range = kNotNegative,
      .slider = {0, 2},
      .help = "leave out samples nearer to another, in spacings (default 0.25)"}});

constexpr auto kMarkRows = joined(kCurveRows, kSampleRows);

/// Calls `visit("--option", field)` for the options on ends and kinks of curves.
template <class Visit>
void visit_curves(CurveOptions& curves, const Visit& visit) {
  visit("--join", curves.join);
  visit("--trim", curves.trim);
  visit("--fair", curves.fair);
}

}  // namespace brindle
