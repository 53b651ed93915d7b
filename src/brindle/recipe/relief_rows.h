/// Option rows: reliefs.
#pragma once

#include "brindle/option_table.h"
#include "brindle/recipe/row_words.h"

namespace brindle {

constexpr auto kReliefRows =
    in_group({.group = "Relief", .one_process = kNeedsWhole, .jobs = kRelief},
             {{.name = "height",
               .common = true,
               .kind = OptionKind::length,
               .range = kPositive,
               .slider = {0.01, 5, true},
               .help = "height of the texture above the surface"},
              {.name = "tolerance",
               .common = true,
               .kind = OptionKind::length,
               .range = kPositive,
               .slider = {0.001, 1, true},
               .help = "greatest error (default: a twentieth of the height)"},
              {.name = "keep-flat",
               .common = true,
               .kind = OptionKind::flag,
               .help = "leave flat faces wider than the spacing as they are"},
              {.name = "only",
               .common = true,
               .form = "AXIS[@DEG]|X,Y,Z[@DEG]|FILE.csv",
               .files = ".csv",
               .help = "faces within DEG (default 45) of a direction, or weights above 0.5"},
              {.name = "inlay",
               .common = true,
               .kind = OptionKind::length,
               .range = kNotNegative,
               .slider = {0, 5},
               .excludes = "cut fill-holes",
               .help = "closed bodies from this depth to the height, one for each motif"},
              {.name = "cut",
               .common = true,
               .kind = OptionKind::flag,
               .excludes = "fill-holes inlay",
               .help = "a shell as thick as the height, with motifs as slots through it"},
              {.name = "fill-holes",
               .kind = OptionKind::length,
               .standard = "50%",
               .range = kNotNegative,
               .excludes = "cut inlay",
               .help = "fill holes up to this perimeter, without texture (default 50%)"}});

}  // namespace brindle
