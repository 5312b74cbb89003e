#!/bin/bash
# Who writes OBJ files keeps other numbers of digits. Open3D 0.19.0 writes six significant ones: a triangle of one metre,
# a hundred kilometres from the origin, as in mapping, comes back with its corners moved by a fifth of its size, from
# 64-bit numbers and without a word. trimesh 5.2.0 writes eight decimals, so that one of 10 micrometres is off by 0.04 % and
# one of 5 nanometres is a point. A good engineer expects the numbers back, as meshio 5.3.5 gives them, or as many digits
# as tell floats apart, nine.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check open3d==0.19.0 trimesh==5.2.0 meshio==5.3.5 numpy==1.26.4

cat > write.py <<'PYTHON'
import meshio, numpy, open3d, trimesh

def by_open3d(corners):
    points, indices = open3d.utility.Vector3dVector(corners), open3d.utility.Vector3iVector([[0, 1, 2]])
    open3d.io.write_triangle_mesh('mesh.obj', open3d.geometry.TriangleMesh(points, indices))

def by_trimesh(corners):
    trimesh.Trimesh(corners, [[0, 1, 2]], process=False).export('mesh.obj')

def by_meshio(corners):
    meshio.write_points_cells('mesh.obj', corners, [('triangle', numpy.array([[0, 1, 2]]))])

shape = numpy.array([[1 / 3, 0, 0], [1, 1 / 7, 0], [0, 1 / 9, 1 / 11]])
cases = {'1 m at 100 km': shape + [123456.789, 0, 0], '10 um': shape * 1e-5, '5 nm': shape * 5e-9}
for write in by_open3d, by_trimesh, by_meshio:
    for name, corners in cases.items():
        write(corners)
        lines = [line.split() for line in open('mesh.obj')]
        back = numpy.array([[float(word) for word in line[1:4]] for line in lines if line[:1] == ['v']])
        error = abs(back - corners).max() / numpy.ptp(corners, axis=0).max()
        print(f'{write.__name__} {name}: off by {error:.0e} of its size')
PYTHON
venv/bin/python write.py | tee seen.txt

diff seen.txt - <<'EXPECTED'
by_open3d 1 m at 100 km: off by 2e-01 of its size
by_open3d 10 um: off by 3e-07 of its size
by_open3d 5 nm: off by 7e-07 of its size
by_trimesh 1 m at 100 km: off by 3e-09 of its size
by_trimesh 10 um: off by 3e-04 of its size
by_trimesh 5 nm: off by 1e+00 of its size
by_meshio 1 m at 100 km: off by 0e+00 of its size
by_meshio 10 um: off by 0e+00 of its size
by_meshio 5 nm: off by 0e+00 of its size
EXPECTED
