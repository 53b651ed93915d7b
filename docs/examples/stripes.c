#include <brindle_c.h>
#include <stdio.h>

int main(void) {
  const double points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0.2, 0, 1, 0}; /* x, y, z per vertex */
  const int triangles[] = {0, 1, 2, 0, 2, 3};
  const float frequency = 3; /* stripes per unit length */
  brindle_surface *surface = NULL;
  brindle_field *field = NULL;
  brindle_pattern *pattern = NULL;
  brindle_array phases;
  size_t i;
  const int failed =
      brindle_make_surface(brindle_array_of(points, BRINDLE_FLOAT64, 4, 3),
                           brindle_array_of(triangles, BRINDLE_INT32, 2, 3), NULL, NULL, &surface) ||
      brindle_make_smooth_field(surface, NULL, NULL, &field) ||
      brindle_make_stripes(surface, field, brindle_array_of(&frequency, BRINDLE_FLOAT32, 1, 1), NULL,
                           NULL, &pattern) ||
      brindle_get_pattern_array(pattern, BRINDLE_PATTERN_PHASES, &phases);
  if (failed) fprintf(stderr, "%s\n", brindle_error()); /* what is wrong, and what to do about it */
  for (i = 0; !failed && i < phases.rows; ++i) {
    const float *z = (const float *)phases.data + 2 * i;
    printf("%.6f %.6f\n", z[0], z[1]);
  }
  brindle_free_pattern(pattern);
  brindle_free_field(field);
  brindle_free_surface(surface);
  return failed;
}
