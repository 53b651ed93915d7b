/* Prints a hash of every array that C programs get. results.cpp prints the same with the C++
 * library; a test compares both. */
#include <brindle_c.h>
#include <stdio.h>
#include <stdlib.h>

static void check(brindle_status status, const char* what) {
  if (status == BRINDLE_OK) return;
  fprintf(stderr, "%s: %s\n", what, brindle_error());
  exit(1);
}

static size_t size_of(brindle_type type) {
  static const size_t sizes[] = {4, 8, 1, 1, 2, 2, 4, 4, 8, 8};
  return sizes[type];
}

static void print_array(const char* name, brindle_array a) {
  const size_t size = size_of(a.type);
  const ptrdiff_t column = a.column_stride != 0 ? a.column_stride : (ptrdiff_t)size;
  const ptrdiff_t row = a.row_stride != 0 ? a.row_stride : (ptrdiff_t)(size * a.columns);
  uint64_t hash = 0xcbf29ce484222325u;
  size_t i, c, b;
  for (i = 0; i < a.rows; ++i) {
    for (c = 0; c < a.columns; ++c) {
      const unsigned char* number =
          (const unsigned char*)a.data + (ptrdiff_t)i * row + (ptrdiff_t)c * column;
      for (b = 0; b < size; ++b) hash = (hash ^ number[b]) * 0x100000001b3u;
    }
  }
  printf("%s %lu %lu %016llx\n", name, (unsigned long)a.rows, (unsigned long)a.columns,
         (unsigned long long)hash);
}

#define PRINT_ALL(get, handle, type, first, last)    \
  do {                                               \
    int which;                                       \
    for (which = first; which <= last; ++which) {    \
      brindle_array array;                           \
      check(get(handle, (type)which, &array), #get); \
      print_array(#last, array);                     \
    }                                                \
  } while (0)

static brindle_array one(const float* frequency) {
  return brindle_array_of(frequency, BRINDLE_FLOAT32, 1, 1);
}

static void print_pattern(const brindle_pattern* pattern) {
  brindle_metrics m;
  brindle_curves* curves;
  PRINT_ALL(brindle_get_pattern_array, pattern, brindle_pattern_array, BRINDLE_PATTERN_PHASES,
            BRINDLE_PATTERN_TRIANGLE_KINDS);
  check(brindle_get_metrics(pattern, &m), "metrics");
  printf("%lu %lu %lu %.17g %.17g %.17g\n", (unsigned long)m.branches,
         (unsigned long)m.field_singularities, (unsigned long)m.vertices_without_wave,
         m.angle_error, m.spacing_error, m.energy);
  check(brindle_trace_curves(pattern, NULL, NULL, &curves), "curves");
  PRINT_ALL(brindle_get_curves_array, curves, brindle_curves_array, BRINDLE_CURVES_POINTS,
            BRINDLE_CURVES_ENDS);
  brindle_free_curves(curves);
}

static void print_patterns(const brindle_surface* surface, const float* f) {
  brindle_field *smooth, *vector, *curvature, *turned;
  brindle_pattern *u, *v;
  brindle_samples* samples;
  brindle_stripe_options options = brindle_default_stripe_options();
  check(brindle_make_smooth_field(surface, NULL, NULL, &smooth), "smooth");
  check(brindle_make_vector_field(surface, 0.3, 0.9, 0.2, &vector), "vector");
  check(brindle_make_curvature_field(surface, 1, &curvature), "curvature");
  check(brindle_make_turned_field(surface, smooth, 90, &turned), "turned");
  check(brindle_make_stripes(surface, smooth, one(f), NULL, NULL, &u), "u");
  check(brindle_make_stripes(surface, turned, one(f), NULL, NULL, &v), "v");
  print_pattern(u);
  print_pattern(v);
  check(brindle_make_samples(u, v, NULL, &samples), "samples");
  PRINT_ALL(brindle_get_samples_array, samples, brindle_samples_array, BRINDLE_SAMPLES_POSITIONS,
            BRINDLE_SAMPLES_BARYCENTRIC);
  brindle_free_samples(samples);
  brindle_free_pattern(u);
  options.slack = 0.3f;
  options.cycles = 1;
  check(brindle_make_stripes(surface, vector, one(f), &options, NULL, &u), "slack");
  print_pattern(u);
  brindle_free_pattern(u);
  options = brindle_default_stripe_options();
  check(brindle_get_pattern_array(v, BRINDLE_PATTERN_PHASES, &options.last_phases), "phases");
  check(brindle_make_stripes(surface, curvature, one(f), &options, NULL, &u), "follows");
  print_pattern(u);
  brindle_free_pattern(u);
  brindle_free_pattern(v);
  brindle_free_field(smooth);
  brindle_free_field(vector);
  brindle_free_field(curvature);
  brindle_free_field(turned);
}

static void print_textures(const brindle_surface* surface, const float* f) {
  brindle_smooth_options crosses = brindle_default_smooth_options();
  const brindle_array none = brindle_array_of(NULL, BRINDLE_FLOAT32, 0, 1);
  brindle_field *lines, *cross;
  brindle_texture* texture;
  brindle_pattern* v;
  crosses.symmetry = 4;
  check(brindle_make_smooth_field(surface, NULL, NULL, &lines), "lines");
  check(brindle_make_smooth_field(surface, &crosses, NULL, &cross), "cross");
  check(brindle_make_texture(surface, lines, one(f), none, 0, NULL, NULL, &texture), "texture");
  PRINT_ALL(brindle_get_texture_array, texture, brindle_texture_array, BRINDLE_TEXTURE_POSITIONS,
            BRINDLE_TEXTURE_TRIANGLE_ORIGINS);
  check(brindle_copy_texture_pattern(texture, 1, &v), "v");
  print_pattern(v);
  brindle_free_pattern(v);
  brindle_free_texture(texture);
  check(brindle_make_crosses(surface, cross, one(f), NULL, NULL, &texture), "crosses");
  PRINT_ALL(brindle_get_texture_array, texture, brindle_texture_array, BRINDLE_TEXTURE_POSITIONS,
            BRINDLE_TEXTURE_TRIANGLE_ORIGINS);
  brindle_free_texture(texture);
  brindle_free_field(lines);
  brindle_free_field(cross);
}

static void print_frames(const brindle_surface* surface, const float* f, const char* file) {
  brindle_animator_options options = brindle_default_animator_options();
  brindle_animator* animator;
  brindle_array positions;
  brindle_pattern_vertex* vertices;
  int n;
  options.slack = 0.2f;
  check(brindle_make_animator(surface, &options, &animator), "animator");
  check(brindle_get_surface_array(surface, BRINDLE_SURFACE_POSITIONS, &positions), "positions");
  vertices = malloc(positions.rows * sizeof *vertices);
  if (vertices == NULL) exit(1);
  for (n = 0; n < 4; ++n) {
    brindle_field* field;
    brindle_frame_input input = {{0}, {0}, {0}};
    brindle_frame_result result;
    check(brindle_make_vector_field(surface, 0.3, 0.9, 0.1 * n, &field), "field");
    check(brindle_get_field_array(field, &input.directions), "directions");
    input.frequencies = one(f);
    check(brindle_solve_frame(animator, &input, NULL, &result), "frame");
    print_array("phases", result.phases);
    print_array("frequencies", result.frequencies);
    printf("%.17g %d\n", result.phase_step, result.unchanged);
    check(brindle_fill_frame(animator, vertices, positions.rows), "fill");
    print_array("vertices", brindle_array_of(vertices, BRINDLE_FLOAT32, positions.rows, 12));
    brindle_free_field(field);
    if (n != 1) continue; /* goes on from a file */
    check(brindle_save_animator(animator, file), "save");
    brindle_free_animator(animator);
    check(brindle_load_animator(file, &animator), "load");
    remove(file);
  }
  free(vertices);
  brindle_free_animator(animator);
}

int main(int argc, char** argv) {
  const float frequency = 9;
  brindle_surface_options options = brindle_default_surface_options();
  brindle_surface* surface;
  int n;
  if (argc != 2) return 2;
  options.crease_angle = 40;
  for (n = 0; n < 2; ++n) {
    check(brindle_make_shape(n == 0 ? "torus,resolution=24" : "box,resolution=12", &options, NULL,
                             &surface),
          "shape");
    PRINT_ALL(brindle_get_surface_array, surface, brindle_surface_array, BRINDLE_SURFACE_POSITIONS,
              BRINDLE_SURFACE_COPIED);
    print_patterns(surface, &frequency);
    print_frames(surface, &frequency, argv[1]);
    if (n == 0) print_textures(surface, &frequency);
    brindle_free_surface(surface);
  }
  return 0;
}
