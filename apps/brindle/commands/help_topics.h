/// Explanations that several options share: 'brindle help TOPIC'.
#pragma once

#include <array>
#include <string_view>

namespace brindle::tool {

struct HelpTopic {
  std::string_view name, summary, text;
};

inline constexpr std::array<HelpTopic, 7> kHelpTopics = {{
    {"inputs", "files and shapes that commands read",
     R"(MESH is one of these:

  FILE.vtp .vtu .vtk    VTK, with arrays at points and cells
  FILE.ply .obj .stl .off .gltf .glb
                        a mesh; a file without faces has points
  FILE.csv              points: x,y,z, or x,y,z and a normal, in each row
  shape:NAME            a built-in shape; 'brindle --shapes' lists them
  shape:torus,resolution=64,noise=0.2
                        with parameters

'brindle info MESH' describes one, with its arrays. --points takes only the vertices of a mesh.
Other files: fields and values (.csv; 'brindle help arrays'), strokes (.json; see docs/files.md).
)"},
    {"arrays", "fields and arrays of files, and columns of CSV files",
     R"(--field takes one of these:

  array:NAME            vectors (2 or 3 components) or symmetric tensors (6 or 9) of MESH
  array:points/NAME     the array of the points, if the cells also have one of this name
  array:cells/NAME      the array of the cells
  FILE.csv              the only vector or tensor of a CSV file; one row per vertex
  FILE.csv:NAME         the one called NAME
  smooth                the smoothest field
  curvature             a smooth field that is attracted to principal curvature
  raw-curvature         principal curvature alone

'brindle info MESH' lists the arrays of a file. Vectors are projected onto the surface; their
lengths do not count. --tensor selects an eigenvector. A vertex has no wave if its row is zero or
not finite.

The first row of a CSV file may name the columns, in any order:

  x, y, z               a field, then optionally frequency and frequency_v: larger is denser
  NAME:0, NAME:1 ...    an array NAME; also NAME_0 ... and NAME_x to NAME_z
  NAME:XX, YY, ZZ ...   a tensor NAME: XX, YY, ZZ, XY, YZ, XZ, or all nine
  east, north           a field on a globe around 0,0,0 with axis z

Without names, the columns are x,y,z[,frequency[,frequency_v]]. Commas, semicolons, tabs or spaces
separate them.
)"},
    {"values", "VALUE of --color-by, --width-by, --frequency-by and others",
     R"(VALUE is one of these:

  array:NAME            an array of MESH; vectors count by their magnitude
  FILE.csv[:COLUMN]     a column of a CSV file; one row per vertex
  distance:X,Y,Z        distance from a point, in the coordinates of the file
  distance:camera       distance from the camera; a zoom does not change it
  curvature             the principal curvature of larger magnitude, with its sign
  height                z, or the axis of --up
  light                 lightness of the surface in the picture, 0 (black) to 1 (white)
  coherence             coherence of the directions of data, with --field-smoothing

Behind it follows what the smallest and the largest value give, as @A..B:

  --color-by VALUE@A..B     the colour map goes from the value A to the value B
  --frequency-by VALUE@A..B[,inverse|reciprocal]
                            factors of the frequency; inverse: B at the smallest value;
                            reciprocal: one over the value, clamped to A and B
  --width-by VALUE@A..B     shares of the period, or pixels: @1px..5px
  --opacity-by, --tile-size-by, --size-by VALUE@A..B
                            shares
)"},
    {"lengths", "lengths, the spacing of stripes, sizes on paper",
     R"(A length is L, in the units of MESH, or P%, in percent of the diagonal of its bounding box.

One of these options gives the spacing of the stripes:

  --spacing L|P%        the distance between stripes
  --stripes N           the diagonal divided by N
  --frequency F         1 / F

A period is that distance, at each place of the surface.

Sizes on paper:

  --size 297mmx210mm    the page, in mm, cm or in; without units, pixels
  --scale MM:UNITS      1:1 draws a unit of MESH as a millimetre, 25.4:1 as an inch; needs
                        --camera ...,orthographic
  --dpi D               pixels of a .png in an inch; required for a .png of such a size or scale

A drawing (.svg, .pdf) has 96 pixels in an inch.
)"},
    {"cameras", "cameras, light and slices of pictures",
     R"(  --camera AZIMUTH,ELEVATION[,ZOOM]
                        angles in degrees. At 0,0 the camera is in front. A larger azimuth moves
                        it counter-clockwise, seen from above; elevation 90 is above. ZOOM 2
                        shows the middle at twice the size.
  --camera SIDE[,ZOOM]  front, back, left, right, top or bottom
  --up AXIS             the axis that points up: z for shapes and .stl, else y
  --camera ...,orthographic
                        parallel lines stay parallel
  --light-from AZIMUTH,ELEVATION
                        degrees from the viewer: 90,0 is the right, 0,90 above
  --slice x=0.2         removes larger coordinates along x, y or z, in the units of the file
  --slice x=50%         the same, in percent of the bounding box
  --slice -x=50%        removes smaller coordinates
  --slice X,Y,Z,NX,NY,NZ
                        removes the side of a plane through X,Y,Z to which NX,NY,NZ points
)"},
    {"outputs", "files that commands write, by extension",
     R"(All commands write a report as .json. The other files are:

  stripe    .png                  picture
            .svg .pdf             drawing with areas of stripes
            .vtp .ply .gltf .glb  mesh with its arrays and the arrays below
            .obj                  mesh alone
  curves    .obj .ply .vtp .csv   lines
            .obj .ply .vtp .gltf .glb
                                  tubes, with --tube-radius
            .svg .pdf             drawing without hidden lines
            .png                  picture with tubes
  paths     .gcode .dxf           moves and polylines of a machine
            .csv .vtp .ply .obj   points with directions, widths, speeds and poses
            .png                  picture with tubes
  sample    .csv .ply .vtp        points with normal, directions, spacings and place
            .png                  picture with glyphs
  animate   .mp4 %04d.png         video, pictures
            %04d.vtp              meshes of a series, and a .pvd that lists them

Arrays at vertices:

  phase                 radians; not a number if valid is 0, which means no wave
  sin_phase             sine of the phase: 1 on crests
  direction, frequency  of the wave
  branch                1 at triangles in which a stripe begins or ends
  original_id           the number of the vertex in MESH

stripe --texture adds texture coordinates and the image of the tile, --uv coordinates alone.
)"},
    {"solver", "solvers and their parameters",
     R"(A solver finds the phases of the waves. 'brindle compare' runs all of them.

  multilevel            Brindle's own: from coarse to fine levels that carry phases
  relaxation            the paper's local method, from a random start
  averaged              the paper's hierarchy of averaged directions
  global                the eigenvector of Knoeppel et al.; it takes most time

Parameters follow behind commas, as in

  --solver multilevel,cycles=3
  --solver relaxation,epsilon=0.001,seed=7

A parameter that the solver does not use is rejected. 'compare', which has no --solver, has them
as options of their own: --cycles 3.
)"},
}};

}  // namespace brindle::tool
