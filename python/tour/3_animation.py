# %% [markdown]
# # An animation
# Directions, frequencies and positions may change from frame to frame; the stripes follow calmly.
# What depends on the triangles alone is built in the first frame.

# %% A surface and an animator.
import time

import numpy as np

import brindle

surface = brindle.shape("torus", resolution=120)
animator = brindle.Animator(surface, stiffness=0.025)
rest = np.array(surface.vertices)

# %% Thirty frames: the direction turns, the frequency grows, a wave runs through the surface.
phases = np.empty(surface.vertex_count, np.complex64)
for number in range(30):
    angle = np.radians(number)
    directions = surface.projected_field((np.cos(angle), np.sin(angle), 0.3))
    frequency = surface.frequency_of(20) * 1.01**number
    positions = rest + np.float32([0, 0, 0.02]) * np.sin(5 * rest[:, :1] + 0.2 * number)
    begin = time.perf_counter()
    animator.frame(directions, frequency, positions, out=phases)
    took = 1000 * (time.perf_counter() - begin)
    if number % 10 == 9:
        print(f"frame {number}: {took:.1f} ms, phases moved by {animator.phase_step:.3f} radians")

# %% The last frame as a pattern, to measure and to draw.
moved = surface.with_vertices(positions)
pattern = brindle.advanced.stripes_from_phases(moved, phases, directions, frequency=frequency)
print(pattern.report["branches"], "branches")
brindle.write_png("frame.png", brindle.render(moved, pattern, size=(600, 450)))

# %% A field that follows a brush: anchors draw it at some vertices.
field = brindle.FieldAnimator(surface)
before = field.frame()
stroke = np.arange(0, 40)
after = field.frame(stroke, np.tile([0, 0, 1.0], (len(stroke), 1)), 20)
print("turned by the stroke:", int((np.abs((before * after).sum(axis=1)) < 0.9).sum()), "vertices")
