#!/bin/bash
# A BMP file of 32 bits a pixel without compression (BI_RGB) is opaque in Pillow 13.0.0 and
# OpenCV 5.0.0, and wholly transparent in OpenImageIO 3.2.2 and Mitsuba 3.9.1, which take the fourth byte for alpha. That byte is
# reserved in such a file, and usually 0: only a BITMAPV4HEADER has an alpha mask. A good engineer expects two readers of
# so old a format to show the same picture; a comparison of images in one, or a texture in the other, shows none.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check pillow==13.0.0 opencv-python-headless==5.0.0.93 \
  OpenImageIO==3.2.2.0 mitsuba==3.9.1 drjit==1.5.0 numpy==2.4.6

cat > read.py <<'PYTHON'
import struct
import cv2, mitsuba, numpy, OpenImageIO, PIL.Image

# Two pixels: (30, 20, 10) and (60, 50, 40).
pixels = bytes([10, 20, 30, 0, 40, 50, 60, 0])
header = struct.pack('<IiiHHIIiiII', 40, 2, 1, 1, 32, 0, len(pixels), 2835, 2835, 0, 0)
with open('two.bmp', 'wb') as file:
    file.write(b'BM' + struct.pack('<IHHI', 14 + len(header) + len(pixels), 0, 0, 14 + len(header)) + header + pixels)

mitsuba.set_variant('scalar_rgb')
print('Pillow:', *numpy.array(PIL.Image.open('two.bmp'))[0].tolist())
print('OpenCV, blue first:', *cv2.imread('two.bmp', cv2.IMREAD_UNCHANGED)[0].tolist())
print('OpenImageIO:', *OpenImageIO.ImageBuf('two.bmp').get_pixels(OpenImageIO.UINT8)[0].tolist())
print('Mitsuba:', *numpy.array(mitsuba.Bitmap('two.bmp'))[0].tolist())
PYTHON
venv/bin/python read.py | tee seen.txt

diff seen.txt - <<'EXPECTED'
Pillow: [30, 20, 10] [60, 50, 40]
OpenCV, blue first: [10, 20, 30] [40, 50, 60]
OpenImageIO: [30, 20, 10, 0] [60, 50, 40, 0]
Mitsuba: [30, 20, 10, 0] [60, 50, 40, 0]
EXPECTED
