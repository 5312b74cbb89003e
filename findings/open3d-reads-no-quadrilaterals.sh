#!/bin/bash
# Open3D 0.19.0: read_triangle_mesh leaves out every face of an OBJ file that is not a triangle, and returns the rest as a
# success; the only sign is a line of information. A file of quadrilaterals is an empty mesh. Where post-processing
# is asked for, which triangulates, it leaves out the triangles, too. A good engineer expects a "triangle mesh" reader
# to triangulate, as this one does of PLY, and as the same package's newer reader, open3d.t.io, does of the same file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check open3d==0.19.0 numpy==1.26.4

# A square, and a triangle beside it.
cat > mixed.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
f 1 2 3 4
f 2 5 3
OBJ
sed '/^f 2/d' mixed.obj > square.obj
cat > square.ply <<'PLY'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
PLY
venv/bin/python - <<'PYTHON' > seen.txt
import open3d
read = open3d.io.read_triangle_mesh
print('mixed.obj:', len(read('mixed.obj').triangles), 'triangles,',
      len(read('mixed.obj', enable_post_processing=True).triangles), 'with post-processing,',
      len(open3d.t.io.read_triangle_mesh('mixed.obj').triangle.indices), 'by the newer reader')
for name in 'square.obj', 'square.ply':
    print(name + ':', len(read(name).triangles), 'triangles')
PYTHON
sed -i '/^\[Open3D/d' seen.txt
cat seen.txt

diff seen.txt - <<'EXPECTED'
mixed.obj: 1 triangles, 0 with post-processing, 3 by the newer reader
square.obj: 0 triangles
square.ply: 2 triangles
EXPECTED
