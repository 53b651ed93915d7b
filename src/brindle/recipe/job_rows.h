/// Rows of the table: what jobs write, where pictures are taken from, and how frames follow each
/// other.
#pragma once

#include "brindle/option_table.h"
#include "brindle/recipe/row_words.h"

namespace brindle {

constexpr auto kPictureRows =
    in_group({.group = "Picture", .jobs = kStripe | kCurves | kSample | kAnimate},
             {{.name = "camera",
               .kind = OptionKind::text,
               .form = "AZIMUTH,ELEVATION[,ZOOM]",
               .standard = "30,20",
               .help = "picture: where from, in degrees (default 30,20)"},
              {.name = "size",
               .kind = OptionKind::text,
               .form = "WIDTHxHEIGHT",
               .standard = "1200x900",
               .help = "picture: pixels (default 1200x900)"},
              {.name = "quality",
               .kind = OptionKind::choice,
               .form = "interactive|final",
               .standard = "final",
               .help = "picture: drawn fast, or with care (default final)"}});

constexpr auto kOutputRows = in_group(
    {.group = "Output", .jobs = kStripe | kCurves | kSample},
    {{.name = "uv",
      .kind = OptionKind::flag,
      .jobs = kStripe,
      .help = "meshes with texture coordinates: U across the stripes, one unit a period; vertices "
              "are split where it needs that (original_id: their number in MESH)"},
     {.name = "output",
      .kind = OptionKind::text,
      .form = "FILE",
      .several = true,
      .help = "what to write, by extension; repeatable"},
     {.name = "output",
      .kind = OptionKind::text,
      .form = "%04d.png|FILE.mp4|%04d.vtp",
      .several = true,
      .jobs = kAnimate,
      .help = "one picture a frame, a video through the ffmpeg program, or one mesh for each step "
              "of a series; repeatable"},
     {.name = "report",
      .kind = OptionKind::text,
      .form = "FILE.json",
      .file = true,
      .help = "write the report here"},
     {.name = "report",
      .kind = OptionKind::text,
      .form = "FILE.json",
      .file = true,
      .jobs = kAnimate,
      .help = "write the figures of all frames here"},
     {.name = "quiet",
      .kind = OptionKind::flag,
      .jobs = kAll,
      .help = "print nothing but errors"}});

constexpr auto kFrameRows = in_group(
    {.group = "Frames", .jobs = kAnimate},
    {{.name = "direction",
      .kind = OptionKind::text,
      .form = "X,Y,Z",
      .excludes = "field",
      .help = "zoom, rotate, wobble: the global vector (default 0.31,0.9,0.27); series: one vector "
              "for all vertices, instead of --field"},
     {.name = "solver",
      .kind = OptionKind::choice,
      .form = "multilevel|relaxation",
      .standard = "multilevel",
      .help = "multilevel (default), or the paper's iterations from the last frame's phases"},
     {.name = "phase-shift",
      .kind = OptionKind::choice,
      .form = "aligned|trapezoid",
      .standard = "aligned",
      .help = "distance between two waves"},
     {.name = "lambda",
      .kind = OptionKind::number,
      .form = "L",
      .standard = "0.025",
      .range = kWeight,
      .help = "multilevel: how strongly a frame holds on to the last one; 0: not at all (default "
              "0.025)"},
     {.name = "between",
      .kind = OptionKind::whole,
      .form = "K",
      .standard = "0",
      .range = {.least = 0, .most = 1000},
      .slider = {0, 20},
      .help = "series: K frames between two steps, interpolated (default 0)"},
     {.name = "scene",
      .kind = OptionKind::choice,
      .form = "zoom|vortices|rotate|wobble|brush",
      .standard = "zoom",
      .help = "what changes (default zoom)"},
     {.name = "frames",
      .kind = OptionKind::whole,
      .form = "N",
      .standard = "121",
      .range = {.least = 1, .most = 1000000},
      .slider = {1, 1000, true},
      .help = "how many (default 121: frames 0 to 120)"},
     {.name = "series",
      .kind = OptionKind::text,
      .form = "'v%04d.vtp'|'v*.vtp'|FILE.pvd|FILE.series",
      .help =
          "the files of a time series instead of a scene: names with a number or a wildcard (in "
          "quotes), or a .pvd or .vtu.series; with MESH, .csv files with a field each"},
     {.name = "iterations",
      .kind = OptionKind::whole,
      .form = "N",
      .standard = "3",
      .range = {.least = 1, .most = 10000},
      .slider = {1, 20},
      .help = "relaxation: iterations a frame (default 3)"},
     {.name = "fps",
      .kind = OptionKind::whole,
      .form = "N",
      .unit = "frames per second",
      .standard = "30",
      .range = {.least = 1, .most = 1000},
      .slider = {1, 60},
      .help = "video: frames a second (default 30)"},
     {.name = "compare-from-scratch",
      .kind = OptionKind::flag,
      .help = "also solve every frame without its last one, and print both"},
     {.name = "between-stripes",
      .kind = OptionKind::choice,
      .form = "surface|nothing",
      .help = "picture: what is between stripes or beside the figures of a texture; with nothing, "
              "what lies behind is seen in its own colours"},
     {.name = "texture-flow",
      .kind = OptionKind::text,
      .form = "U[,V]",
      .help = "--texture: lets all tiles flow, so many a second"}});

constexpr auto kJobRows = joined(kPictureRows, kOutputRows, kFrameRows);

}  // namespace brindle
