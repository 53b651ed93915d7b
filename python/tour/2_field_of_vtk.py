# %% [markdown]
# # A vector field of VTK's data
# A sphere in a flow: VTK makes the surface and the velocities on it, Brindle the stripes, and VTK
# gets the phases back as arrays for its own filters.

# %% A surface with data, as a reader or a filter of VTK gives it.
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import brindle

source = vtk.vtkSphereSource()
source.SetThetaResolution(120)
source.SetPhiResolution(120)
source.Update()
sphere = source.GetOutput()

points = vtk_to_numpy(sphere.GetPoints().GetData())
velocity = np.cross([0.2, 0.3, 1], points) + [0, 0, 0.15]
array = numpy_to_vtk(velocity, deep=1)
array.SetName("velocity")
sphere.GetPointData().AddArray(array)
speed = numpy_to_vtk(np.linalg.norm(velocity, axis=1), deep=1)
speed.SetName("speed")
sphere.GetPointData().AddArray(speed)

# %% Arrays go by their names. Stripes across the flow, denser where it is fast.
surface = brindle.as_surface(sphere)
dense = surface.frequencies_by("speed", stripes=25, range=(0.6, 1.6))
pattern = brindle.stripes(surface, "velocity", frequency=dense)
print(pattern.report["branches"], "branches,", pattern.report["vertices_without_wave"], "vertices without")

# %% Back into VTK: phase, sin_phase, direction, frequency, branch and corner_phase are arrays there.
pattern.add_to(sphere)
writer = vtk.vtkXMLPolyDataWriter()
writer.SetInputData(sphere)
writer.SetFileName("sphere.vtp")
writer.Write()

# %% VTK's own filters work on them: contours of the phase's sine are the stripes' borders.
contour = vtk.vtkContourFilter()
contour.SetInputData(sphere)
contour.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "sin_phase")
contour.SetValue(0, 0.0)
contour.Update()
print(contour.GetOutput().GetNumberOfLines(), "pieces of the borders")
