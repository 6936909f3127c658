#!/usr/bin/env python3
"""The last frame of a run in two dimensions as a picture:
python3 draw_fields.py results/biaxial [FIELD [FILE.png]]
Needs VTK's Python and Matplotlib (Debian: python3-vtk9, python3-matplotlib), and no display."""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot
from matplotlib.collections import PolyCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

folder, field = Path(sys.argv[1]), "".join(sys.argv[2:3]) or "void_ratio"
last = xml.parse(folder / "domains.pvd").findall(".//DataSet")[-1]
reader = vtkXMLPolyDataReader()
reader.SetFileName(str(folder / last.get("file")))
reader.Update()
cells = reader.GetOutput()
corners = 1e3 * vtk_to_numpy(cells.GetPoints().GetData())[:, :2]  # [mm]
corners = corners[vtk_to_numpy(cells.GetPolys().GetConnectivityArray())].reshape(cells.GetNumberOfCells(), -1, 2)
figure, axes = plot.subplots(figsize=(4, 7))
drawn = axes.add_collection(PolyCollection(corners, array=vtk_to_numpy(cells.GetCellData().GetArray(field))))
axes.autoscale()
axes.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", title=f"{field}, t = {float(last.get('timestep')):.4g} s")
figure.colorbar(drawn)
figure.savefig("".join(sys.argv[3:4]) or f"{field}.png", dpi=150)
