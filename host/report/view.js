// The pictures: decoding, drawing at whole zooms, moving, values.

// Device pixels for one of the picture.
const ZOOMS = [1 / 16, 1 / 8, 1 / 4, 1 / 3, 1 / 2, 1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32, 48, 64];
const palette = document.body.dataset.palette.match(/../g).map((digits) => parseInt(digits, 16));

const view = {pair: null, name: 'side', zoom: 1, x: 0, y: 0, split: 0.5, third: 'difference', shown: 'image',
              brighter: 1, ring: true, hover: null};
const panes = document.getElementById('panes');
let surfaces = [];  // of the panes: {canvas, context, kind}

// Picture elements by pair and kind. Those of the pairs looked at last are kept.
const decoded = new Map();
const KEPT_PAIRS = 6;

async function decode(pair, kind) {
  const source = document.getElementById(`${pair.number}-${kind}`);
  if (!source) return null;
  const image = new Image();
  image.src = 'data:image/png;base64,' + source.textContent;
  await image.decode();
  return kind === 'flip' ? colored(image) : image;
}

// FLIP's map in colours, and as it is.
function colored(grey) {
  const canvas = document.createElement('canvas');
  canvas.width = grey.naturalWidth;
  canvas.height = grey.naturalHeight;
  const context = canvas.getContext('2d');
  context.drawImage(grey, 0, 0);
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < pixels.data.length; i += 4) {
    const color = 3 * pixels.data[i];
    for (let k = 0; k < 3; ++k) pixels.data[i + k] = palette[color + k];
  }
  context.putImageData(pixels, 0, 0);
  canvas.grey = grey;
  return canvas;
}

async function picturesOf(pair) {
  let found = decoded.get(pair.number);
  decoded.delete(pair.number);
  if (!found) {
    const kinds = ['image', 'reference', 'difference', 'flip', 'image-values', 'reference-values'];
    const pictures = await Promise.all(kinds.map((kind) => decode(pair, kind)));
    found = Object.fromEntries(kinds.map((kind, i) => [kind, pictures[i]]));
    // Of equal pictures there is one in the page.
    if (pair.equal) {
      found.reference = found.image;
      found['reference-values'] = found['image-values'];
    }
  }
  decoded.set(pair.number, found);
  if (decoded.size > KEPT_PAIRS) decoded.delete(decoded.keys().next().value);
  return found;
}

const widthOf = (picture) => picture.naturalWidth ?? picture.width;
const heightOf = (picture) => picture.naturalHeight ?? picture.height;

function pictureSize() {
  const one = view.pictures && (view.pictures.image || view.pictures.reference);
  return one ? {width: widthOf(one), height: heightOf(one)} : {width: 1, height: 1};
}

// Of the first pane, in device pixels; all have the same size.
function paneSize() {
  const canvas = surfaces[0]?.canvas;
  return canvas ? {width: canvas.width, height: canvas.height} : {width: 1, height: 1};
}

// Where the picture's corner is in a pane.
function corner() {
  const pane = paneSize();
  return {x: Math.round(pane.width / 2 - view.x * view.zoom), y: Math.round(pane.height / 2 - view.y * view.zoom)};
}

function fit() {
  const picture = pictureSize(), pane = paneSize();
  const most = Math.min(pane.width / picture.width, pane.height / picture.height);
  view.zoom = ZOOMS.findLast((zoom) => zoom <= most) ?? ZOOMS[0];
  view.x = picture.width / 2;
  view.y = picture.height / 2;
  view.fitted = true;
  draw();
}

// By so many steps; the point of the panes at (x, y), by default the middle, stays.
function zoomBy(steps, at) {
  const pane = paneSize();
  const point = at ?? {x: pane.width / 2, y: pane.height / 2};
  const before = view.zoom;
  const step = Math.min(Math.max(ZOOMS.indexOf(before) + steps, 0), ZOOMS.length - 1);
  view.zoom = ZOOMS[step];
  const scale = 1 / before - 1 / view.zoom;
  moveTo(view.x + (point.x - pane.width / 2) * scale, view.y + (point.y - pane.height / 2) * scale);
}

function moveTo(x, y) {
  const picture = pictureSize();
  view.x = Math.min(Math.max(x, 0), picture.width);
  view.y = Math.min(Math.max(y, 0), picture.height);
  view.fitted = false;
  draw();
}

// The picture at a size of 1/n, for each pixel the largest of n x n: a mean would hide a difference of few pixels.
function largestOf(picture, n) {
  const smaller = (picture.smaller ??= {});
  if (smaller[n]) return smaller[n];
  const read = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  const width = read.canvas.width = widthOf(picture), height = read.canvas.height = heightOf(picture);
  read.drawImage(picture, 0, 0);
  const from = read.getImageData(0, 0, width, height).data;
  const canvas = document.createElement('canvas');
  canvas.width = Math.ceil(width / n);
  canvas.height = Math.ceil(height / n);
  const context = canvas.getContext('2d');
  const pixels = context.createImageData(canvas.width, canvas.height);
  // Of FLIP's colours the brightest as a whole, so that no others come out.
  const brightness = (i) => from[i] + from[i + 1] + from[i + 2];
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const i = 4 * (y * width + x), to = 4 * (Math.floor(y / n) * canvas.width + Math.floor(x / n));
      const there = pixels.data[to] + pixels.data[to + 1] + pixels.data[to + 2];
      if (pixels.data[to + 3] === 0 || brightness(i) > there) pixels.data.set(from.subarray(i, i + 4), to);
    }
  }
  context.putImageData(pixels, 0, 0);
  return (smaller[n] = canvas);
}

function drawPicture(context, picture, kind) {
  const at = corner(), isDifference = kind === 'difference' || kind === 'flip';
  const n = isDifference && view.zoom < 1 ? Math.round(1 / view.zoom) : 1;
  const drawn = n > 1 ? largestOf(picture, n) : picture;
  context.imageSmoothingEnabled = view.zoom < 1 && !isDifference;
  context.imageSmoothingQuality = 'high';
  context.drawImage(drawn, at.x, at.y, widthOf(drawn) * n * view.zoom, heightOf(drawn) * n * view.zoom);
}

// Where the slider's line is: a share of the part of the picture that is seen.
function sliderLine() {
  const at = corner(), pane = paneSize();
  const left = Math.max(at.x, 0), right = Math.min(at.x + pictureSize().width * view.zoom, pane.width);
  return {left, right, x: Math.round(left + view.split * (right - left))};
}

function stroke(context, path, color) {
  context.lineWidth = 3;
  context.strokeStyle = 'rgb(0 0 0 / 70%)';
  context.stroke(path);
  context.lineWidth = 1.5;
  context.strokeStyle = color;
  context.stroke(path);
}

function drawMarks(context) {
  const at = corner(), zoom = view.zoom;
  const largest = view.pair.largest;
  if (view.ring && largest) {
    const ring = new Path2D();
    const radius = Math.max(9 * devicePixelRatio, zoom);
    ring.arc(at.x + (largest.x + 0.5) * zoom, at.y + (largest.y + 0.5) * zoom, radius, 0, 2 * Math.PI);
    stroke(context, ring, '#fff');
  }
  if (view.hover && zoom >= 4) {
    const box = new Path2D();
    box.rect(at.x + view.hover.x * zoom - 1, at.y + view.hover.y * zoom - 1, zoom + 2, zoom + 2);
    stroke(context, box, '#ffd54a');
  }
}

function drawSurface({canvas, context, kind}) {
  context.clearRect(0, 0, canvas.width, canvas.height);
  canvas.style.filter = kind === 'difference' && view.brighter > 1 ? `brightness(${view.brighter})` : '';
  const pictures = view.pictures;
  const show = (name) => pictures[name] && drawPicture(context, pictures[name], name);
  if (kind !== 'slider') {
    show(kind === 'flicker' ? view.shown : kind);
    return drawMarks(context);
  }
  const line = sliderLine();
  show('reference');
  context.save();
  context.beginPath();
  context.rect(0, 0, line.x, canvas.height);
  context.clip();
  context.clearRect(0, 0, canvas.width, canvas.height);
  show('image');
  context.restore();
  const path = new Path2D();
  path.moveTo(line.x, 0);
  path.lineTo(line.x, canvas.height);
  stroke(context, path, '#fff');
  drawMarks(context);
}

function draw() {
  if (!view.pictures) return;
  for (const surface of surfaces) drawSurface(surface);
  document.getElementById('zoom').textContent = view.zoom >= 1 ? `× ${view.zoom}` : `÷ ${Math.round(1 / view.zoom)}`;
}

// A pixel's value as it is in the file, a number for each channel, or null outside of the picture.
const probe = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
function bytesAt(picture, x, y) {
  probe.imageSmoothingEnabled = false;
  probe.drawImage(picture, x, y, 1, 1, 0, 0, 1, 1);
  return probe.getImageData(0, 0, 1, 1).data;
}

function valuesAt(which, x, y) {
  const picture = view.pictures[which], bits = view.pictures[which + '-values'];
  if (!picture || x < 0 || y < 0 || x >= widthOf(picture) || y >= heightOf(picture)) return null;
  if (!bits) return Array.from(bytesAt(picture, x, y).slice(0, 3), (byte) => byte / 255);
  const height = heightOf(picture);
  const copies = Array.from({length: heightOf(bits) / height}, (_, k) => bytesAt(bits, x, y + k * height));
  const float = (channel, first) => {
    const number = new DataView(new ArrayBuffer(4));
    for (let k = 0; k < 4; ++k) number.setUint8(k, copies[first + k][channel]);
    return number.getFloat32(0, true);
  };
  return [...[0, 1, 2].map((channel) => float(channel, 0)), ...(copies.length > 4 ? [float(0, 4)] : [])];
}
