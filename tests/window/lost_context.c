/* Preloaded by tests/scripts/window_test.py: OpenGL says that the graphics driver was reset, as soon as
   the file that LOST_CONTEXT_SIGN names is there. */
#include <stdlib.h>
#include <unistd.h>

typedef unsigned (*ResetStatus)(void);

/* Programs that do not use OpenGL have none. */
extern ResetStatus epoxy_glGetGraphicsResetStatus __attribute__((weak));

static unsigned status(void) {
  const unsigned guilty = 0x8253; /* GL_GUILTY_CONTEXT_RESET */
  const char* sign = getenv("LOST_CONTEXT_SIGN");
  return sign != NULL && access(sign, F_OK) == 0 ? guilty : 0;
}

__attribute__((constructor)) static void take_place(void) {
  if (&epoxy_glGetGraphicsResetStatus != NULL) epoxy_glGetGraphicsResetStatus = status;
}
