# %% [markdown]
# # Curves to make things of
# Centre lines of stripes for plotters, milling, wire and weaving; points for rivets and pins.

# %% Two families of lines, along a field and across it, joined where they would end in branches.
import numpy as np

import brindle

surface = brindle.shape("vessels")
along = surface.smooth_field(curvature_anchor=0.1)
across = surface.rotate_field(along, 90)
warp = brindle.stripes(surface, along, stripes=30).curves(join=True, min_length=0.1)
weft = brindle.stripes(surface, across, stripes=30).curves(join=True, min_length=0.1)
for name, curves in (("warp", warp), ("weft", weft)):
    print(name, curves.count, "curves,", int(curves.closed.sum()), "closed, length",
          round(float(curves.lengths.sum()), 2))

# %% Points at equal distances along the lines, for a machine: positions, and the surface's normals.
even = brindle.stripes(surface, along, stripes=30).curves(resample=0.02)
steps = [np.linalg.norm(np.diff(line, axis=0), axis=1).mean() for line in even.lines if len(line) > 2]
print("step", round(float(np.mean(steps)), 4))
np.savetxt("path.csv", np.hstack([even.points, even.normals]), delimiter=",",
           header="x,y,z,nx,ny,nz", comments="")

# %% Drawings with hidden lines removed, and files for other programs.
warp.write("warp.svg")
warp.write("warp.obj")

# %% Tubes to print: a surface like any other.
tubes = warp.tubes(0.004)
tubes.write("warp.ply")
print(tubes)

# %% Where both families cross: regular points, with what is there.
points, normals = samples = brindle.samples(surface, along, stripes=30)
samples.write("pins.csv")
print(samples.count, "points, nearest neighbours at", round(samples.report["nearest_neighbour"]["mean"], 2),
      "of the spacing")
