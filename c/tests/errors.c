/* What is wrong is an error with a message, and leaves handles, outputs and files as they are. */
#include <brindle_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, int line, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "errors.c:%d: %s; last error: %s\n", line, what, brindle_error());
}

static int fails(brindle_status status, brindle_status wanted, const char* message) {
  return status == wanted && strstr(brindle_error(), message) != NULL;
}

#define EXPECT(condition) expect((condition), __LINE__, #condition)
#define OK(call) EXPECT((call) == BRINDLE_OK)
#define FAILS(call, message) EXPECT(fails((call), BRINDLE_ERROR, message))
/* A function that makes a handle sets it to NULL. */
#define MAKES_NOTHING(call, handle, message) \
  do {                                       \
    handle = (void*)&failures;               \
    FAILS(call, message);                    \
    EXPECT(handle == NULL);                  \
  } while (0)

static const double kPositions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0.2, 0, 1, 0};
static const int64_t kTriangles[] = {0, 1, 2, 0, 2, 3};
static const float kFrequency = 9;

static brindle_array array_of(const void* data, brindle_type type, size_t rows, size_t columns) {
  return brindle_array_of(data, type, rows, columns);
}
static brindle_array positions(void) { return array_of(kPositions, BRINDLE_FLOAT64, 4, 3); }
static brindle_array triangles(void) { return array_of(kTriangles, BRINDLE_INT64, 2, 3); }
static brindle_array one(const float* number) { return array_of(number, BRINDLE_FLOAT32, 1, 1); }
static brindle_array none(void) { return array_of(NULL, BRINDLE_FLOAT32, 0, 1); }

static void test_surfaces(void) {
  double bad[12];
  int64_t corners[6];
  brindle_surface* s;
  brindle_array a;
  brindle_surface_options o = brindle_default_surface_options();
  brindle_array wrong = positions();
  MAKES_NOTHING(
      brindle_make_surface(array_of(NULL, BRINDLE_FLOAT64, 4, 3), triangles(), NULL, NULL, &s), s,
      "positions: data is NULL");
  MAKES_NOTHING(brindle_make_surface(array_of(kPositions, BRINDLE_FLOAT64, 4, 2), triangles(), NULL,
                                     NULL, &s),
                s, "2 columns");
  MAKES_NOTHING(
      brindle_make_surface(positions(), array_of(kTriangles, BRINDLE_INT64, 3, 2), NULL, NULL, &s),
      s, "triangles has 2 columns");
  MAKES_NOTHING(
      brindle_make_surface(positions(), array_of(NULL, BRINDLE_INT64, 0, 3), NULL, NULL, &s), s,
      "no triangles");
  MAKES_NOTHING(
      brindle_make_surface(array_of(NULL, BRINDLE_FLOAT64, 0, 3), triangles(), NULL, NULL, &s), s,
      "vert");
  wrong.type = (brindle_type)77;
  MAKES_NOTHING(brindle_make_surface(wrong, triangles(), NULL, NULL, &s), s, "type 77");
  wrong = positions();
  wrong.rows = (size_t)-1;
  MAKES_NOTHING(brindle_make_surface(wrong, triangles(), NULL, NULL, &s), s, "too many rows");
  memcpy(bad, kPositions, sizeof bad);
  bad[4] = NAN;
  MAKES_NOTHING(
      brindle_make_surface(array_of(bad, BRINDLE_FLOAT64, 4, 3), triangles(), NULL, NULL, &s), s,
      "vertex 1");
  bad[4] = INFINITY;
  MAKES_NOTHING(
      brindle_make_surface(array_of(bad, BRINDLE_FLOAT64, 4, 3), triangles(), NULL, NULL, &s), s,
      "vertex 1");
  memcpy(corners, kTriangles, sizeof corners);
  corners[5] = 4;
  MAKES_NOTHING(
      brindle_make_surface(positions(), array_of(corners, BRINDLE_INT64, 2, 3), NULL, NULL, &s), s,
      "triangle 1");
  corners[5] = -1;
  MAKES_NOTHING(
      brindle_make_surface(positions(), array_of(corners, BRINDLE_INT64, 2, 3), NULL, NULL, &s), s,
      "triangle 1");
  corners[5] = 0;
  MAKES_NOTHING(
      brindle_make_surface(positions(), array_of(corners, BRINDLE_INT64, 2, 3), NULL, NULL, &s), s,
      "triangle 1");
  o.repair = 1; /* drops it */
  OK(brindle_make_surface(positions(), array_of(corners, BRINDLE_INT64, 2, 3), &o, NULL, &s));
  OK(brindle_get_surface_array(s, BRINDLE_SURFACE_TRIANGLES, &a));
  EXPECT(a.rows == 1 && a.columns == 3 && a.type == BRINDLE_UINT32);
  brindle_free_surface(s);
  o.repair = 2;
  MAKES_NOTHING(brindle_make_surface(positions(), triangles(), &o, NULL, &s), s,
                "repair must be 0 or 1");
  o = brindle_default_surface_options();
  o.crease_angle = NAN;
  MAKES_NOTHING(brindle_make_surface(positions(), triangles(), &o, NULL, &s), s, "angle");
  FAILS(brindle_make_surface(positions(), triangles(), NULL, NULL, NULL), "NULL");
  MAKES_NOTHING(brindle_read_surface(NULL, NULL, NULL, &s), s, "path is NULL");
  MAKES_NOTHING(brindle_read_surface("no/such.ply", NULL, NULL, &s), s, "no/such.ply");
  MAKES_NOTHING(brindle_make_shape(NULL, NULL, NULL, &s), s, "shape is NULL");
  MAKES_NOTHING(brindle_make_shape("taurus", NULL, NULL, &s), s, "taurus");
  MAKES_NOTHING(
      brindle_make_points(positions(), array_of(kPositions, BRINDLE_FLOAT64, 3, 3), NULL, &s), s,
      "3 normals for 4 points");
  MAKES_NOTHING(brindle_make_points(array_of(NULL, BRINDLE_FLOAT64, 0, 3), none(), NULL, &s), s,
                "");
  FAILS(brindle_get_surface_array(NULL, BRINDLE_SURFACE_POSITIONS, &a), "surface is NULL");
  EXPECT(a.data == NULL && a.rows == 0);
  FAILS(brindle_get_surface_origin(NULL, bad), "surface is NULL");
}

static void test_strides(void) {
  /* Rows in reverse, with other numbers in between, give the mesh of packed ones. */
  float mixed[4][5];
  brindle_surface *s, *t;
  brindle_array a = {0}, b, c;
  size_t i, k;
  for (i = 0; i < 4; ++i) {
    for (k = 0; k < 3; ++k) mixed[3 - i][k + 1] = (float)kPositions[3 * i + k];
    mixed[i][0] = mixed[i][4] = NAN;
  }
  a.data = &mixed[3][1];
  a.rows = 4;
  a.columns = 3;
  a.row_stride = -(ptrdiff_t)sizeof mixed[0];
  a.type = BRINDLE_FLOAT32;
  OK(brindle_make_surface(a, triangles(), NULL, NULL, &s));
  OK(brindle_make_surface(positions(), triangles(), NULL, NULL, &t));
  OK(brindle_get_surface_array(s, BRINDLE_SURFACE_POSITIONS, &b));
  OK(brindle_get_surface_array(t, BRINDLE_SURFACE_POSITIONS, &c));
  EXPECT(b.rows == 4 && memcmp(b.data, c.data, 4 * 3 * sizeof(float)) == 0);
  FAILS(brindle_get_surface_array(s, (brindle_surface_array)9, &b), "number 9");
  EXPECT(b.data == NULL);
  FAILS(brindle_get_surface_array(s, (brindle_surface_array)-1, &b), "number -1");
  FAILS(brindle_get_surface_array(s, BRINDLE_SURFACE_NORMALS, NULL), "array is NULL");
  FAILS(brindle_get_surface_origin(s, NULL), "origin is NULL");
  brindle_free_surface(s);
  brindle_free_surface(t);
}

static void test_fields(const brindle_surface* s, const brindle_surface* other) {
  brindle_field *f, *g;
  brindle_array a;
  brindle_smooth_options o = brindle_default_smooth_options();
  o.symmetry = 0;
  MAKES_NOTHING(brindle_make_smooth_field(NULL, NULL, NULL, &f), f, "surface is NULL");
  MAKES_NOTHING(brindle_make_smooth_field(s, &o, NULL, &f), f, "symmetry");
  o = brindle_default_smooth_options();
  o.feature_anchor = NAN;
  MAKES_NOTHING(brindle_make_smooth_field(s, &o, NULL, &f), f, "");
  o = brindle_default_smooth_options();
  o.minimum_curvature = -1;
  MAKES_NOTHING(brindle_make_smooth_field(s, &o, NULL, &f), f, "minimum_curvature");
  o.minimum_curvature = 1;
  MAKES_NOTHING(brindle_make_smooth_field(s, &o, NULL, &f), f, "needs a curvature_anchor");
  MAKES_NOTHING(brindle_make_vector_field(s, 0, 0, 0, &f), f, "");
  MAKES_NOTHING(brindle_make_vector_field(s, NAN, 0, 1, &f), f, "");
  MAKES_NOTHING(brindle_make_vector_field(NULL, 0, 0, 1, &f), f, "surface is NULL");
  MAKES_NOTHING(brindle_make_curvature_field(s, 2, &f), f, "minimum");
  MAKES_NOTHING(brindle_make_curvature_field(NULL, 0, &f), f, "surface is NULL");
  MAKES_NOTHING(brindle_make_array_field(s, positions(), &f), f, "4 rows");
  MAKES_NOTHING(brindle_make_array_field(s, none(), &f), f, "");
  MAKES_NOTHING(brindle_make_array_field(NULL, positions(), &f), f, "surface is NULL");
  OK(brindle_make_vector_field(s, 0, 0, 1, &f));
  MAKES_NOTHING(brindle_make_turned_field(s, NULL, 90, &g), g, "field is NULL");
  MAKES_NOTHING(brindle_make_turned_field(s, f, NAN, &g), g, "finite");
  MAKES_NOTHING(brindle_make_turned_field(other, f, 90, &g), g, "another surface");
  FAILS(brindle_get_field_array(NULL, &a), "field is NULL");
  FAILS(brindle_get_field_array(f, NULL), "array is NULL");
  brindle_free_field(f);
}

static void test_patterns(const brindle_surface* s, const brindle_surface* other,
                          const char* file) {
  const float bad[] = {0, -1, NAN, 1e30f};
  brindle_field* f;
  brindle_pattern *p, *q;
  brindle_texture* t;
  brindle_curves* c;
  brindle_samples* m;
  brindle_array a;
  brindle_metrics metrics;
  brindle_curve_options curves = brindle_default_curve_options();
  brindle_stripe_options o = brindle_default_stripe_options();
  brindle_pattern_vertex vertex;
  brindle_pattern_triangle triangle;
  FILE* damaged;
  size_t i;
  OK(brindle_make_vector_field(s, 0.2, 0.1, 1, &f));
  MAKES_NOTHING(brindle_make_stripes(NULL, f, one(&kFrequency), NULL, NULL, &p), p,
                "surface is NULL");
  MAKES_NOTHING(brindle_make_stripes(s, NULL, one(&kFrequency), NULL, NULL, &p), p,
                "field is NULL");
  MAKES_NOTHING(brindle_make_stripes(other, f, one(&kFrequency), NULL, NULL, &p), p,
                "another surface");
  MAKES_NOTHING(brindle_make_stripes(s, f, none(), NULL, NULL, &p), p, "no rows");
  MAKES_NOTHING(brindle_make_stripes(s, f, array_of(bad, BRINDLE_FLOAT32, 2, 1), NULL, NULL, &p), p,
                "2 rows");
  for (i = 0; i < 4; ++i) {
    MAKES_NOTHING(brindle_make_stripes(s, f, one(bad + i), NULL, NULL, &p), p, "");
  }
  o.solver = (brindle_solver)4;
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "solver");
  o = brindle_default_stripe_options();
  o.sweeps = -1;
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "sweeps");
  o = brindle_default_stripe_options();
  o.slack = NAN;
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "slack");
  o = brindle_default_stripe_options();
  o.slacks = one(&kFrequency);
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "slacks has 1 rows");
  o = brindle_default_stripe_options();
  OK(brindle_get_field_array(f, &a));
  o.avoid_branches = a;
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "3 columns");
  o.avoid_branches.columns = 1;
  o.avoid_branches.row_stride = 3 * sizeof(float);
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p,
                "no effect without slack");
  o = brindle_default_stripe_options();
  o.last_phases = a;
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "3 columns");
  o.last_phases.columns = 2;
  o.last_phases.row_stride = 3 * sizeof(float);
  MAKES_NOTHING(brindle_make_stripes(s, f, one(&kFrequency), &o, NULL, &p), p, "");
  MAKES_NOTHING(brindle_make_texture(s, f, one(&kFrequency), none(), 0, &o, NULL, &t), t,
                "last_phases");
  MAKES_NOTHING(brindle_make_crosses(s, f, one(&kFrequency), &o, NULL, &t), t, "last_phases");
  MAKES_NOTHING(brindle_make_texture(s, f, one(&kFrequency), none(), 3, NULL, NULL, &t), t,
                "oriented");
  MAKES_NOTHING(brindle_make_texture(s, f, one(&kFrequency), one(bad + 1), 0, NULL, NULL, &t), t,
                "");
  MAKES_NOTHING(brindle_make_texture(s, NULL, one(&kFrequency), none(), 0, NULL, NULL, &t), t,
                "field is NULL");
  MAKES_NOTHING(brindle_make_crosses(s, f, none(), NULL, NULL, &t), t, "no rows");
  OK(brindle_make_stripes(s, f, one(&kFrequency), NULL, NULL, &p));
  FAILS(brindle_get_pattern_array(p, (brindle_pattern_array)5, &a), "number 5");
  FAILS(brindle_get_pattern_array(NULL, BRINDLE_PATTERN_PHASES, &a), "pattern is NULL");
  FAILS(brindle_get_metrics(NULL, &metrics), "pattern is NULL");
  FAILS(brindle_get_metrics(p, NULL), "metrics is NULL");
  FAILS(brindle_fill_buffers(p, &vertex, 1, &triangle, 1), "the pattern has");
  FAILS(brindle_fill_buffers(p, NULL, 1, &triangle, 1), "vertices is NULL");
  FAILS(brindle_fill_buffers(p, &vertex, 1, NULL, 1), "triangles is NULL");
  curves.trim = 0.5f;
  curves.join = 1;
  MAKES_NOTHING(brindle_trace_curves(p, &curves, NULL, &c), c, "");
  curves.trim = -1;
  OK(brindle_trace_curves(p, &curves, NULL, &c));
  brindle_free_curves(c);
  curves = brindle_default_curve_options();
  curves.trim = 2;
  MAKES_NOTHING(brindle_trace_curves(p, &curves, NULL, &c), c, "");
  curves = brindle_default_curve_options();
  curves.resample = NAN;
  MAKES_NOTHING(brindle_trace_curves(p, &curves, NULL, &c), c, "resample");
  curves = brindle_default_curve_options();
  curves.min_length = -1;
  MAKES_NOTHING(brindle_trace_curves(p, &curves, NULL, &c), c, "min_length");
  MAKES_NOTHING(brindle_trace_curves(NULL, NULL, NULL, &c), c, "pattern is NULL");
  OK(brindle_trace_curves(p, NULL, NULL, &c));
  FAILS(brindle_get_curves_array(c, (brindle_curves_array)5, &a), "number 5");
  FAILS(brindle_get_curves_array(NULL, BRINDLE_CURVES_POINTS, &a), "curves is NULL");
  brindle_free_curves(c);
  brindle_free_field(f);
  OK(brindle_make_vector_field(other, 0.2, 0.1, 1, &f));
  OK(brindle_make_stripes(other, f, one(&kFrequency), NULL, NULL, &q));
  brindle_free_field(f);
  MAKES_NOTHING(brindle_make_samples(p, q, NULL, &m), m, "different surfaces");
  MAKES_NOTHING(brindle_make_samples(p, NULL, NULL, &m), m, "v is NULL");
  brindle_free_pattern(q);
  FAILS(brindle_get_samples_array(NULL, BRINDLE_SAMPLES_POSITIONS, &a), "samples is NULL");
  FAILS(brindle_get_texture_array(NULL, BRINDLE_TEXTURE_POSITIONS, &a), "texture is NULL");
  FAILS(brindle_copy_texture_pattern(NULL, 0, &q), "texture is NULL");
  OK(brindle_save_pattern(p, file));
  FAILS(brindle_save_pattern(NULL, file), "pattern is NULL");
  FAILS(brindle_save_pattern(p, NULL), "path is NULL");
  FAILS(brindle_save_pattern(p, "no/such/folder"), "no/such");
  brindle_free_pattern(p);
  OK(brindle_load_pattern(file, &p));
  brindle_free_pattern(p);
  MAKES_NOTHING(brindle_load_pattern(NULL, &p), p, "path is NULL");
  damaged = fopen(file, "r+b");
  EXPECT(damaged != NULL && fseek(damaged, 200, SEEK_SET) == 0 && fputc(77, damaged) == 77);
  if (damaged != NULL) fclose(damaged);
  MAKES_NOTHING(brindle_load_pattern(file, &p), p, file);
  remove(file);
  MAKES_NOTHING(brindle_load_pattern(file, &p), p, file);
}

static int cancel(void* data, double fraction, const char* step) {
  EXPECT(fraction >= 0 && fraction <= 1 && step != NULL);
  return --*(int*)data == 0;
}

static void test_cancelling(const brindle_surface* s) {
  int left = 3;
  brindle_progress progress;
  brindle_field* f = NULL;
  brindle_pattern* p;
  progress.report = cancel;
  progress.data = &left;
  OK(brindle_make_vector_field(s, 0, 0.1, 1, &f));
  p = (void*)&left;
  EXPECT(fails(brindle_make_stripes(s, f, one(&kFrequency), NULL, &progress, &p), BRINDLE_CANCELLED,
               ""));
  EXPECT(p == NULL && left == 0);
  left = 1000000;
  OK(brindle_make_stripes(s, f, one(&kFrequency), NULL, &progress, &p));
  EXPECT(left < 1000000);
  brindle_free_pattern(p);
  brindle_free_field(f);
}

static void test_animators(const brindle_surface* s, const char* file) {
  brindle_animator* n;
  brindle_animator_options o = brindle_default_animator_options();
  brindle_frame_input in = {{0}, {0}, {0}};
  brindle_frame_result result, again;
  brindle_field* f;
  brindle_pattern_vertex vertex;
  brindle_surface* copy;
  MAKES_NOTHING(brindle_make_animator(NULL, NULL, &n), n, "surface is NULL");
  o.lambda = NAN;
  MAKES_NOTHING(brindle_make_animator(s, &o, &n), n, "lambda");
  o = brindle_default_animator_options();
  o.relaxation = 9;
  MAKES_NOTHING(brindle_make_animator(s, &o, &n), n, "relaxation");
  OK(brindle_make_animator(s, NULL, &n));
  OK(brindle_make_vector_field(s, 0, 0.1, 1, &f));
  FAILS(brindle_fill_frame(n, &vertex, 1), "no frame yet");
  FAILS(brindle_fill_frame(n, NULL, 1), "vertices is NULL");
  FAILS(brindle_solve_frame(n, NULL, NULL, &result), "input is NULL");
  FAILS(brindle_solve_frame(n, &in, NULL, &result), "frequencies has no rows");
  in.frequencies = one(&kFrequency);
  FAILS(brindle_solve_frame(n, &in, NULL, &result), "");
  OK(brindle_get_field_array(f, &in.directions));
  FAILS(brindle_solve_frame(NULL, &in, NULL, &result), "animator is NULL");
  FAILS(brindle_solve_frame(n, &in, NULL, NULL), "result is NULL");
  OK(brindle_solve_frame(n, &in, NULL, &result));
  EXPECT(result.phases.columns == 2 && result.phases.rows == in.directions.rows);
  in.positions = positions();
  FAILS(brindle_solve_frame(n, &in, NULL, &again), "");
  EXPECT(again.phases.data == NULL);
  in.positions = none();
  OK(brindle_solve_frame(n, &in, NULL, &again));
  EXPECT(again.unchanged == 1);
  FAILS(brindle_fill_frame(n, &vertex, 1), "vertices");
  FAILS(brindle_set_last_phases(n, positions()), "3 columns");
  FAILS(brindle_set_last_phases(NULL, again.phases), "animator is NULL");
  OK(brindle_set_last_phases(n, again.phases));
  FAILS(brindle_set_slack(n, 0.2f), "without slack");
  FAILS(brindle_set_slack(NULL, 0.2f), "animator is NULL");
  FAILS(brindle_restart(NULL), "animator is NULL");
  OK(brindle_restart(n));
  FAILS(brindle_save_animator(NULL, file), "animator is NULL");
  OK(brindle_save_animator(n, file));
  brindle_free_animator(n);
  MAKES_NOTHING(brindle_load_pattern(file, (brindle_pattern**)&n), n, "holds a StripeAnimator");
  OK(brindle_load_animator(file, &n));
  OK(brindle_copy_animator_surface(n, &copy));
  brindle_free_animator(n);
  OK(brindle_get_surface_array(copy, BRINDLE_SURFACE_POSITIONS, &in.positions));
  EXPECT(in.positions.rows == in.directions.rows);
  brindle_free_surface(copy);
  MAKES_NOTHING(brindle_copy_animator_surface(NULL, &copy), copy, "animator is NULL");
  MAKES_NOTHING(brindle_copy_pattern_surface(NULL, &copy), copy, "pattern is NULL");
  brindle_free_field(f);
  remove(file);
}

int main(int argc, char** argv) {
  brindle_surface *torus, *sphere;
  if (argc != 2) return 2;
  EXPECT(brindle_error()[0] == '\0');
  EXPECT(strlen(brindle_version()) >= 5);
  FAILS(brindle_limit_threads(-1), "threads");
  OK(brindle_limit_threads(1));
  OK(brindle_limit_threads(0));
  OK(brindle_make_shape("torus,resolution=16", NULL, NULL, &torus));
  OK(brindle_make_shape("sphere,resolution=8", NULL, NULL, &sphere));
  test_surfaces();
  test_strides();
  test_fields(torus, sphere);
  test_patterns(torus, sphere, argv[1]);
  test_cancelling(torus);
  test_animators(torus, argv[1]);
  brindle_free_surface(torus);
  brindle_free_surface(sphere);
  brindle_free_surface(NULL);
  brindle_free_field(NULL);
  brindle_free_pattern(NULL);
  brindle_free_texture(NULL);
  brindle_free_curves(NULL);
  brindle_free_samples(NULL);
  brindle_free_animator(NULL);
  if (failures == 0) printf("all errors as expected\n");
  return failures != 0;
}
