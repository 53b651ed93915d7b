# %% [markdown]
# # From a shape to a picture
# Stripes run across the direction that you give: the direction is where the wave travels, and the
# stripes are its crests.

# %% A surface: a built-in shape. brindle.read(path) reads files, brindle.Surface(V, F) takes arrays.
import numpy as np

import brindle

surface = brindle.shape("trefoil")
print(surface, "diagonal", surface.diagonal)

# %% A direction per vertex: along the principal curvature, turned a little so that stripes wind.
directions = surface.rotate_field(surface.curvature_field("max"), 35)
print(directions.shape, "length", np.linalg.norm(directions, axis=1).mean())

# %% Stripes: 40 along the bounding box's diagonal. The report says how good they are.
pattern = brindle.stripes(surface, directions, stripes=40)
for key in ("energy", "branches", "field_singularities", "angle_error_mean_deg"):
    print(key, pattern.report[key])

# %% A picture, and another one of where stripes begin or end.
brindle.write_png("trefoil.png", brindle.render(surface, pattern, size=(600, 450)))
brindle.write_png("branches.png", brindle.render(surface, pattern, size=(600, 450), view="branches"))

# %% A texture along the same field: bricks that follow the tube.
texture = brindle.texture(surface, directions, stripes=20)
brindle.write_png("bricks.png", brindle.render(surface, texture, size=(600, 450), tile="bricks"))
