/// Pictures, drawings for plotters and print, and what is drawn in them. Pictures need OpenGL: a
/// `HeadlessContext`, or a context of the program's window.
#pragma once

#include "brindle/camera.h"
#include "brindle/feature_lines.h"
#include "brindle/glyphs.h"
#include "brindle/headless_context.h"
#include "brindle/image.h"
#include "brindle/ink.h"
#include "brindle/legend.h"
#include "brindle/line_drawing.h"
#include "brindle/renderer.h"
#include "brindle/splats.h"
#include "brindle/stripe_outlines.h"
#include "brindle/styled_picture.h"
#include "brindle/surface_tones.h"
