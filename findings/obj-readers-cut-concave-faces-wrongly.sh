#!/bin/bash
# Of five readers of OBJ files, three cut a concave face into triangles that cover what is not part of it: trimesh 5.2.0 and
# Mitsuba 3.9.1 draw all diagonals from the first corner, and MeshLab's (pymeshlab 2025.7) does so for four corners, though
# not for five. Their triangles of an arrowhead of area 4 cover 12, some of them from behind. VTK 9.7.2 and Assimp cut it
# rightly. The format says nothing of convexity, and modelling programs write such faces, so a good engineer expects
# whoever triangulates to look where the corners are.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check trimesh==5.2.0 mitsuba==3.9.1 drjit==1.5.0 \
  pymeshlab==2025.7.post1 vtk==9.7.2 assimp_py==1.1.0 numpy==2.4.6

cat > four.obj <<'OBJ'
v 0 0 0
v 4 2 0
v 0 4 0
v 2 2 0
f 1 2 3 4
OBJ
cat > five.obj <<'OBJ'
v 0 0 0
v 4 0 0
v 4 3 0
v 2 1 0
v 0 3 0
f 1 2 3 4 5
OBJ
cat > read.py <<'PYTHON'
import assimp_py, mitsuba, numpy, pymeshlab, trimesh, vtk
from vtk.util.numpy_support import vtk_to_numpy
mitsuba.set_variant('scalar_rgb')

def by_trimesh(name):
    mesh = trimesh.load(name, process=False)
    return mesh.vertices, mesh.faces

def by_mitsuba(name):
    mesh = mitsuba.traverse(mitsuba.load_dict({'type': 'obj', 'filename': name}))
    return mesh['vertex_positions'], mesh['faces']

def by_meshlab(name):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(name)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()

def by_vtk(name):
    reader, triangles = vtk.vtkOBJReader(), vtk.vtkTriangleFilter()
    reader.SetFileName(name)
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    mesh = triangles.GetOutput()
    return vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())

def by_assimp(name):
    scene = assimp_py.import_file(name, assimp_py.Process_Triangulate)
    return numpy.array(scene.meshes[0].vertices), numpy.array(scene.meshes[0].indices)

for read in by_trimesh, by_mitsuba, by_meshlab, by_vtk, by_assimp:
    areas = []
    for name in 'four.obj', 'five.obj':
        vertices, faces = (numpy.array(array) for array in read(name))
        a, b, c = numpy.moveaxis(vertices.reshape(-1, 3)[faces.reshape(-1, 3)], 1, 0)
        areas.append(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)
    print(f'{read.__name__}: four corners {areas[0]:g}, five {areas[1]:g}')
PYTHON
venv/bin/python read.py | tee seen.txt

diff seen.txt - <<'EXPECTED'
by_trimesh: four corners 12, five 10
by_mitsuba: four corners 12, five 10
by_meshlab: four corners 12, five 8
by_vtk: four corners 4, five 8
by_assimp: four corners 4, five 8
EXPECTED
