/* Brindle for C and for languages that call C: stripe patterns on surfaces (docs/c.md).
 *
 * A function that makes a handle sets its last argument, to NULL on errors; the caller frees the
 * handle with brindle_free_..., which accepts NULL. Handles may be freed in any order. Threads may
 * read one handle at once; functions that take an animator without const need it alone.
 *
 * Functions return BRINDLE_OK or a status; brindle_error() then describes the error. Failed and
 * cancelled calls change nothing, but set outputs to NULL or zeros. No function throws an exception
 * or ends the program. Pointers may be NULL only where noted; `options` and `progress` always may.
 *
 * Lengths are in the units of the positions, frequencies in stripes per unit length. Names of files
 * are UTF-8 on Windows.
 */
#ifndef BRINDLE_C_H
#define BRINDLE_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) && !defined(_WIN32)
#define BRINDLE_C_API __attribute__((visibility("default")))
#else
#define BRINDLE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors, version, threads, progress ------------------------------------------------------ */

typedef enum brindle_status {
  BRINDLE_OK = 0,
  BRINDLE_ERROR = 1,         /* the input is wrong; the message names cause and remedy */
  BRINDLE_CANCELLED = 2,     /* a progress callback cancelled the call */
  BRINDLE_OUT_OF_MEMORY = 3, /* an allocation failed */
  BRINDLE_INTERNAL_ERROR = 4 /* a defect of Brindle; please report it */
} brindle_status;

/* The message of the last call on this thread that failed; "" before the first. Valid until the
 * next failure on this thread. */
BRINDLE_C_API const char* brindle_error(void);

/* The version at run time, "MAJOR.MINOR.PATCH". */
BRINDLE_C_API const char* brindle_version(void);

/* Limits the threads of the whole process; 0: no limit. Results do not depend on it. Not while
 * another call runs. */
BRINDLE_C_API brindle_status brindle_limit_threads(int threads);

/* Progress of a long call, on the thread of the caller: `fraction` of the whole call from 0 to 1,
 * which never falls, and the name of a step. A result other than 0 cancels the call. The callback
 * must return; it may not throw or jump out. */
typedef struct brindle_progress {
  int (*report)(void* data, double fraction, const char* step);
  void* data; /* first argument of `report` */
} brindle_progress;

/* ---- Arrays ---------------------------------------------------------------------------------- */

typedef enum brindle_type {
  BRINDLE_FLOAT32 = 0,
  BRINDLE_FLOAT64 = 1,
  BRINDLE_INT8 = 2,
  BRINDLE_UINT8 = 3,
  BRINDLE_INT16 = 4,
  BRINDLE_UINT16 = 5,
  BRINDLE_INT32 = 6,
  BRINDLE_UINT32 = 7,
  BRINDLE_INT64 = 8,
  BRINDLE_UINT64 = 9
} brindle_type;

/* A table of numbers in memory: `rows` times `columns`. Strides are in bytes and may be negative; 0
 * stands for packed numbers in packed rows. Input is checked and copied. Output belongs to its
 * handle: it is valid until that is freed, or as noted, and must not be changed. An array without
 * rows stands for none where one is optional. */
typedef struct brindle_array {
  const void* data;
  size_t rows;
  size_t columns;
  ptrdiff_t row_stride;
  ptrdiff_t column_stride;
  brindle_type type;
} brindle_array;

/* A packed table. */
BRINDLE_C_API brindle_array brindle_array_of(const void* data, brindle_type type, size_t rows,
                                             size_t columns);

/* ---- Surfaces -------------------------------------------------------------------------------- */

/* A triangle mesh, or points, with neighbours and normals. Vertices keep their numbers. */
typedef struct brindle_surface brindle_surface;

typedef struct brindle_surface_options {
  float crease_angle; /* 0 to 180: vertices on sharp edges that bend by more are split, so that each
                         side has its own wave; copies come after all others. 180: none. 180 */
  int repair;         /* 1: joins coincident vertices, drops bad triangles; 0: they are errors. 0 */
} brindle_surface_options;

/* The defaults, which NULL stands for. They end each comment above. */
BRINDLE_C_API brindle_surface_options brindle_default_surface_options(void);

/* From n x 3 positions and t x 3 vertex numbers from 0. Errors: numbers that are not finite,
 * corners that are no vertices, triangles that are degenerate or repeated, and edges shorter than
 * 1e-10 or longer than 1e9 on average. */
BRINDLE_C_API brindle_status brindle_make_surface(brindle_array positions, brindle_array triangles,
                                                  const brindle_surface_options* options,
                                                  const brindle_progress* progress,
                                                  brindle_surface** surface);
/* From a file: VTP, VTU, VTK, PLY, OBJ, OFF, STL, glTF or GLB, with the repairs of `repair`. */
BRINDLE_C_API brindle_status brindle_read_surface(const char* path,
                                                  const brindle_surface_options* options,
                                                  const brindle_progress* progress,
                                                  brindle_surface** surface);
/* A built-in shape, such as "torus" or "sphere,resolution=40" (docs/files.md). */
BRINDLE_C_API brindle_status brindle_make_shape(const char* shape,
                                                const brindle_surface_options* options,
                                                const brindle_progress* progress,
                                                brindle_surface** surface);
/* From n x 3 positions without triangles; `normals` n x 3, or none: they are fitted. Curves and
 * textures need triangles. */
BRINDLE_C_API brindle_status brindle_make_points(brindle_array positions, brindle_array normals,
                                                 const brindle_progress* progress,
                                                 brindle_surface** surface);
BRINDLE_C_API void brindle_free_surface(brindle_surface* surface);

typedef enum brindle_surface_array {
  BRINDLE_SURFACE_POSITIONS = 0, /* n x 3 float32, relative to the origin */
  BRINDLE_SURFACE_TRIANGLES = 1, /* t x 3 uint32 */
  BRINDLE_SURFACE_NORMALS = 2,   /* n x 3 float32, of unit length or zero */
  BRINDLE_SURFACE_COPIED = 3     /* c x 1 uint32: which vertex each of the last c vertices copies */
} brindle_surface_array;

BRINDLE_C_API brindle_status brindle_get_surface_array(const brindle_surface* surface,
                                                       brindle_surface_array which,
                                                       brindle_array* array);
/* The absolute place of the positions' zero: three numbers. Zero unless coordinates are far from
 * it, compared with the size of the surface. */
BRINDLE_C_API brindle_status brindle_get_surface_origin(const brindle_surface* surface,
                                                        double origin[3]);

/* ---- Fields ---------------------------------------------------------------------------------- */

/* One direction per vertex: a unit tangent vector up to sign, or zero for no wave. Stripes run
 * across it. */
typedef struct brindle_field brindle_field;

typedef struct brindle_smooth_options {
  int symmetry;           /* 1 vectors, 2 lines, 4 crosses. 2 */
  float curvature_anchor; /* attraction to principal curvature, 0 or above. 0 */
  int minimum_curvature;  /* 1: to the direction of smaller curvature; needs the anchor. 0 */
  float feature_anchor;   /* attraction to sharp edges and boundaries, 0 or above. 0 */
  float normal_radius;    /* detail below this length makes no singularities; 0: off. 0 */
} brindle_smooth_options;

BRINDLE_C_API brindle_smooth_options brindle_default_smooth_options(void);

/* A field that turns as little as possible. */
BRINDLE_C_API brindle_status brindle_make_smooth_field(const brindle_surface* surface,
                                                       const brindle_smooth_options* options,
                                                       const brindle_progress* progress,
                                                       brindle_field** field);
/* The vector (x, y, z), projected onto the surface. Errors: zero, not finite. */
BRINDLE_C_API brindle_status brindle_make_vector_field(const brindle_surface* surface, double x,
                                                       double y, double z, brindle_field** field);
/* The principal direction of larger or, with `minimum` 1, of smaller absolute curvature. */
BRINDLE_C_API brindle_status brindle_make_curvature_field(const brindle_surface* surface,
                                                          int minimum, brindle_field** field);
/* The tangent part of any vectors, n x 3, with or without rows for copied vertices. No wave where
 * they are zero, not finite or along the normal. */
BRINDLE_C_API brindle_status brindle_make_array_field(const brindle_surface* surface,
                                                      brindle_array vectors, brindle_field** field);
/* The field turned about the normals, counter-clockwise seen from outside. */
BRINDLE_C_API brindle_status brindle_make_turned_field(const brindle_surface* surface,
                                                       const brindle_field* field, double degrees,
                                                       brindle_field** turned);
BRINDLE_C_API void brindle_free_field(brindle_field* field);

/* n x 3 float32. */
BRINDLE_C_API brindle_status brindle_get_field_array(const brindle_field* field,
                                                     brindle_array* array);

/* ---- Patterns -------------------------------------------------------------------------------- */

/* Stripes on a surface, with their input and metrics. */
typedef struct brindle_pattern brindle_pattern;

typedef enum brindle_solver {
  BRINDLE_MULTILEVEL = 0,
  BRINDLE_RELAXATION = 1,
  BRINDLE_AVERAGED = 2,
  BRINDLE_GLOBAL = 3 /* an error in builds without CHOLMOD */
} brindle_solver;

/* Arrays by vertex have a row per vertex, with or without rows for copied vertices. */
typedef struct brindle_stripe_options {
  brindle_solver solver;        /* BRINDLE_MULTILEVEL */
  int sweeps;                   /* per level, 0 or above. 2 */
  int cycles;                   /* further descents, 0 or above. 0 */
  float slack;                  /* spacing tolerance S, 0 or above: frequencies from f / (1 + S) to
                                   f (1 + S). 0 */
  brindle_array slacks;         /* S by vertex in place of `slack`. None */
  brindle_array avoid_branches; /* weights by vertex from 0 to 1; need slack. None */
  brindle_array last_phases;    /* n x 2, cosine and sine by vertex, 0 0 where unknown: phases to
                                   stay near. For BRINDLE_MULTILEVEL. None */
  float lambda;                 /* strength of `last_phases`, 0 to 1e6. 0.025 */
} brindle_stripe_options;

BRINDLE_C_API brindle_stripe_options brindle_default_stripe_options(void);

/* Stripes across the field. `frequencies` has one row for the whole surface, or one per vertex.
 * Errors: a field or arrays of another surface, frequencies that are not above zero and finite, or
 * too high for the mesh. */
BRINDLE_C_API brindle_status brindle_make_stripes(const brindle_surface* surface,
                                                  const brindle_field* field,
                                                  brindle_array frequencies,
                                                  const brindle_stripe_options* options,
                                                  const brindle_progress* progress,
                                                  brindle_pattern** pattern);
BRINDLE_C_API void brindle_free_pattern(brindle_pattern* pattern);

typedef enum brindle_pattern_array {
  BRINDLE_PATTERN_PHASES = 0,        /* n x 2 float32: cosine and sine */
  BRINDLE_PATTERN_DIRECTIONS = 1,    /* n x 3 float32 */
  BRINDLE_PATTERN_FREQUENCIES = 2,   /* n x 1 float32, after spacing tolerance */
  BRINDLE_PATTERN_CORNER_PHASES = 3, /* t x 3 float32: phases in radians, linear per triangle */
  BRINDLE_PATTERN_TRIANGLE_KINDS = 4 /* t x 1 uint8: 0 regular, 1 branch, 2 singularity of the
                                        field, 3 without wave */
} brindle_pattern_array;

BRINDLE_C_API brindle_status brindle_get_pattern_array(const brindle_pattern* pattern,
                                                       brindle_pattern_array which,
                                                       brindle_array* array);

typedef struct brindle_metrics {
  size_t branches;            /* triangles in which stripes begin or end */
  size_t field_singularities; /* of these, singularities of the field */
  size_t vertices_without_wave;
  double angle_error;   /* mean, in degrees, weighted by area */
  double spacing_error; /* mean relative error, weighted by area */
  double energy;        /* 0: perfect */
} brindle_metrics;

BRINDLE_C_API brindle_status brindle_get_metrics(const brindle_pattern* pattern,
                                                 brindle_metrics* metrics);

/* Writes the pattern with its surface to a file, whole or not at all. Loading gives the same bits.
 * It rejects files that are damaged, hold something else, or are of a newer version. */
BRINDLE_C_API brindle_status brindle_save_pattern(const brindle_pattern* pattern, const char* path);
BRINDLE_C_API brindle_status brindle_load_pattern(const char* path, brindle_pattern** pattern);

/* ---- Textures and crosses -------------------------------------------------------------------- */

/* Two patterns along orthogonal fields, as texture coordinates. */
typedef struct brindle_texture brindle_texture;

/* Tiles along the field: U with `frequencies`, V with `frequencies_v` or, if that is none, those of
 * U. With `oriented` 1, the signs of directions count. Errors: as for stripes, points without
 * triangles, and directions more than 4 degrees off the surface. */
BRINDLE_C_API brindle_status brindle_make_texture(
    const brindle_surface* surface, const brindle_field* field, brindle_array frequencies,
    brindle_array frequencies_v, int oriented, const brindle_stripe_options* options,
    const brindle_progress* progress, brindle_texture** texture);
/* Tiles along both directions of a cross field, of which `field` has any one. */
BRINDLE_C_API brindle_status brindle_make_crosses(const brindle_surface* surface,
                                                  const brindle_field* field,
                                                  brindle_array frequencies,
                                                  const brindle_stripe_options* options,
                                                  const brindle_progress* progress,
                                                  brindle_texture** texture);
BRINDLE_C_API void brindle_free_texture(brindle_texture* texture);

/* A mesh with a texture coordinate per vertex; one tile is one unit. It begins with the vertices of
 * the surface. */
typedef enum brindle_texture_array {
  BRINDLE_TEXTURE_POSITIONS = 0,       /* m x 3 float32, relative to the surface's origin */
  BRINDLE_TEXTURE_TRIANGLES = 1,       /* s x 3 uint32 */
  BRINDLE_TEXTURE_COORDINATES = 2,     /* m x 2 float32 */
  BRINDLE_TEXTURE_ORIGINS = 3,         /* m x 3 uint32: vertices whose mean each vertex is, in the
                                          mesh of the waves */
  BRINDLE_TEXTURE_TRIANGLE_ORIGINS = 4 /* s x 1 uint32: a triangle of that mesh */
} brindle_texture_array;

BRINDLE_C_API brindle_status brindle_get_texture_array(const brindle_texture* texture,
                                                       brindle_texture_array which,
                                                       brindle_array* array);
/* A copy of the pattern of U (0) or V (1). Error: crosses, whose waves are linked. */
BRINDLE_C_API brindle_status brindle_copy_texture_pattern(const brindle_texture* texture, int v,
                                                          brindle_pattern** pattern);

/* ---- Curves and samples ---------------------------------------------------------------------- */

/* Centre lines of stripes. */
typedef struct brindle_curves brindle_curves;

typedef struct brindle_curve_options {
  int join;   /* 1: joins curves that end at one branch. 0 */
  float trim; /* clearance of ends, 0 to 1, in units of 1 / f; -1: 0.6, or 0 with `join`. -1 */
  float fair; /* removes kinks shorter than this, 0 to 1, in units of 1 / f. 0 */
  float min_length; /* leaves out shorter curves. 0 */
  float resample;   /* distance of points; 0: one per crossed edge. 0 */
} brindle_curve_options;

BRINDLE_C_API brindle_curve_options brindle_default_curve_options(void);

BRINDLE_C_API brindle_status brindle_trace_curves(const brindle_pattern* pattern,
                                                  const brindle_curve_options* options,
                                                  const brindle_progress* progress,
                                                  brindle_curves** curves);
BRINDLE_C_API void brindle_free_curves(brindle_curves* curves);

typedef enum brindle_curves_array {
  BRINDLE_CURVES_POINTS = 0,  /* p x 3 float32, relative to the surface's origin */
  BRINDLE_CURVES_NORMALS = 1, /* p x 3 float32 */
  BRINDLE_CURVES_OFFSETS =
      2,                     /* c + 1 uint32: curve i has points offsets[i] .. offsets[i + 1] - 1 */
  BRINDLE_CURVES_CLOSED = 3, /* c x 1 uint8: 1 if the curve returns to its first point */
  BRINDLE_CURVES_ENDS = 4    /* c x 2 uint8, of first and last point: 0 closed, 1 boundary, 2 no
                                wave, 3 non-manifold edge, 4 branch, 5 singularity, 6 crease */
} brindle_curves_array;

BRINDLE_C_API brindle_status brindle_get_curves_array(const brindle_curves* curves,
                                                      brindle_curves_array which,
                                                      brindle_array* array);

/* Points where two patterns of one surface cross. */
typedef struct brindle_samples brindle_samples;

/* Error: patterns of different surfaces, and builds without nanoflann. */
BRINDLE_C_API brindle_status brindle_make_samples(const brindle_pattern* u,
                                                  const brindle_pattern* v,
                                                  const brindle_progress* progress,
                                                  brindle_samples** samples);
BRINDLE_C_API void brindle_free_samples(brindle_samples* samples);

typedef enum brindle_samples_array {
  BRINDLE_SAMPLES_POSITIONS = 0,    /* s x 3 float32, relative to the surface's origin */
  BRINDLE_SAMPLES_NORMALS = 1,      /* s x 3 float32 */
  BRINDLE_SAMPLES_DIRECTIONS_U = 2, /* s x 3 float32 */
  BRINDLE_SAMPLES_DIRECTIONS_V = 3, /* s x 3 float32 */
  BRINDLE_SAMPLES_SPACINGS = 4,     /* s x 2 float32: of U and V */
  BRINDLE_SAMPLES_TRIANGLES = 5,    /* s x 1 uint32; of points, numbers of points */
  BRINDLE_SAMPLES_BARYCENTRIC = 6   /* s x 3 float32 */
} brindle_samples_array;

BRINDLE_C_API brindle_status brindle_get_samples_array(const brindle_samples* samples,
                                                       brindle_samples_array which,
                                                       brindle_array* array);

/* ---- Buffers for shaders --------------------------------------------------------------------- */

/* In the layout of the installed GLSL (docs/gpu.md). */
typedef struct brindle_pattern_vertex {
  float position[3];
  float frequency;
  float direction[3];
  float cosine; /* of the phase */
  float normal[3];
  float sine;
} brindle_pattern_vertex;

typedef struct brindle_pattern_triangle {
  uint32_t vertices[3];
  uint32_t kind; /* as BRINDLE_PATTERN_TRIANGLE_KINDS */
} brindle_pattern_triangle;

/* Fills memory of the caller, one entry per vertex and per triangle. Error: other numbers. */
BRINDLE_C_API brindle_status brindle_fill_buffers(const brindle_pattern* pattern,
                                                  brindle_pattern_vertex* vertices,
                                                  size_t vertex_count,
                                                  brindle_pattern_triangle* triangles,
                                                  size_t triangle_count);

/* ---- Frames ---------------------------------------------------------------------------------- */

/* Stripes that follow changing input. */
typedef struct brindle_animator brindle_animator;

typedef struct brindle_animator_options {
  int relaxation; /* 1: the paper's iterations; 0: multilevel. 0 */
  float lambda;   /* attraction to the last frame, 0 to 1e6. 0.025 */
  int sweeps;     /* per level, 0 or above. 2 */
  int cycles;     /* further descents, 0 or above. 0 */
  int iterations; /* per frame of the relaxation, above 0. 3 */
  float slack;    /* spacing tolerance, as in brindle_stripe_options. 0 */
} brindle_animator_options;

BRINDLE_C_API brindle_animator_options brindle_default_animator_options(void);

BRINDLE_C_API brindle_status brindle_make_animator(const brindle_surface* surface,
                                                   const brindle_animator_options* options,
                                                   brindle_animator** animator);
BRINDLE_C_API void brindle_free_animator(brindle_animator* animator);

/* Input of a frame, one row per vertex of the surface, copied vertices included. */
typedef struct brindle_frame_input {
  brindle_array positions;   /* n x 3; none: those of the surface */
  brindle_array directions;  /* n x 3 unit tangent vectors, or zero for no wave */
  brindle_array frequencies; /* n x 1, or 1 x 1 */
} brindle_frame_input;

/* Output of a frame; arrays are valid until the next frame. */
typedef struct brindle_frame_result {
  brindle_array phases;      /* n x 2 float32: cosine and sine */
  brindle_array frequencies; /* n x 1 float32, after spacing tolerance */
  double phase_step;         /* mean change since the last frame, in radians */
  int unchanged;             /* 1: input and phases are those of the last frame */
} brindle_frame_result;

BRINDLE_C_API brindle_status brindle_solve_frame(brindle_animator* animator,
                                                 const brindle_frame_input* input,
                                                 const brindle_progress* progress,
                                                 brindle_frame_result* result);
/* The vertices of the last frame, for shaders; one entry per vertex. Errors: no frame yet, also
 * since the animator was loaded; another number; points without triangles. */
BRINDLE_C_API brindle_status brindle_fill_frame(brindle_animator* animator,
                                                brindle_pattern_vertex* vertices,
                                                size_t vertex_count);
/* Makes the next frame follow these phases, n x 2, 0 0 where unknown, of its directions. */
BRINDLE_C_API brindle_status brindle_set_last_phases(brindle_animator* animator,
                                                     brindle_array phases);
/* Changes the spacing tolerance. Error: an animator that was made without any. */
BRINDLE_C_API brindle_status brindle_set_slack(brindle_animator* animator, float slack);
/* Solves the next frame from scratch. */
BRINDLE_C_API brindle_status brindle_restart(brindle_animator* animator);

/* As for patterns. All frames of an animator that is loaded have the bits that those of the saved
 * one have. */
BRINDLE_C_API brindle_status brindle_save_animator(const brindle_animator* animator,
                                                   const char* path);
BRINDLE_C_API brindle_status brindle_load_animator(const char* path, brindle_animator** animator);
/* Copies of their surfaces. */
BRINDLE_C_API brindle_status brindle_copy_animator_surface(const brindle_animator* animator,
                                                           brindle_surface** surface);
BRINDLE_C_API brindle_status brindle_copy_pattern_surface(const brindle_pattern* pattern,
                                                          brindle_surface** surface);

#ifdef __cplusplus
}
#endif

#endif
