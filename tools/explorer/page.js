// The views of one render: decoding, drawing to both sides of a line, zoom, values.

const $ = (id) => document.getElementById(id);
const data = JSON.parse($('data').textContent);
const pane = document.querySelector('.pane'), canvas = pane.querySelector('canvas'), context = canvas.getContext('2d');

// Device pixels for one of the picture.
const ZOOMS = [1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const view = {name: 'normal', zoom: 1, x: 0, y: 0, split: 0.5, hover: null, fitted: true};
const STOPS = [[0, 0, 0], [30, 40, 190], [200, 20, 90], [250, 130, 20], [255, 235, 60], [255, 255, 255]];
const ABOUT = {
  normal: 'The unit normal that is shaded with: red is right, green up, blue to the viewer.',
  depth: 'Distance from the camera along the ray, in the scene’s units; near is bright.',
  object: 'Which object of the file is seen.',
  shadow: 'Share of the lights that are not blocked; of a spherical light, of the directions to it.',
  cost: 'Nodes and primitives that the rays of a sample are tested against; logarithmic.',
  samples: 'Samples that the pixel was given for the target error; logarithmic.',
  error: 'Estimated error of the pixel, in units of a colour.',
};
const images = {};  // by view: {width, height, values: a number for each pixel and channel, canvas}

async function decode(name) {
  const {png, bytes, channels, least, step} = data.views[name];
  const picture = new Image();
  picture.src = 'data:image/png;base64,' + png;
  await picture.decode();
  const width = picture.naturalWidth, height = picture.naturalHeight / (bytes * channels);
  const read = new OffscreenCanvas(width, picture.naturalHeight).getContext('2d', {willReadFrequently: true});
  read.drawImage(picture, 0, 0);
  const from = read.getImageData(0, 0, width, picture.naturalHeight).data;
  const count = width * height, values = new Float64Array(count * channels);
  for (let channel = 0; channel < channels; ++channel) {
    for (let i = 0; i < count; ++i) {
      let whole = 0;
      for (let byte = 0; byte < bytes; ++byte) whole = 256 * whole + from[4 * ((channel * bytes + byte) * count + i)];
      values[i * channels + channel] = least + step * whole;
    }
  }
  return {width, height, channels, values};
}

function ramp(share) {
  const place = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1), i = Math.min(Math.floor(place), STOPS.length - 2);
  return STOPS[i].map((value, k) => value + (STOPS[i + 1][k] - value) * (place - i));
}

// Apart from its neighbours' by the golden angle.
function hue(number) {
  if (number === 0) return [0, 0, 0];
  const angle = number * 2.39996, light = 0.62 + 0.16 * (number % 3);
  return [0, 2.1, 4.2].map((shift) => 255 * light * (0.62 + 0.38 * Math.cos(angle + shift)));
}

function colorOf(name, value, range) {
  switch (name) {
    case 'color': return value;
    case 'normal': return value.map((part) => 127.5 * (part + 1));
    case 'depth': return Array(3).fill(value[0] === 0 ? 0 : 255 - 215 * (value[0] - range[0]) / (range[1] - range[0] || 1));
    case 'object': return hue(value[0]);
    case 'shadow': return Array(3).fill(255 * value[0]);
    case 'cost':
    case 'samples': return ramp(Math.log2(Math.max(value[0], 1)) / Math.max(Math.log2(range[1]), 1));
    default: return ramp(value[0] / (range[1] || 1));
  }
}

function draw(name) {
  const image = images[name], {width, height, channels, values} = image;
  const seen = channels === 1 ? values.filter((value) => value > 0) : [0, 1];
  image.range = [seen, seen].map((all, i) => all.reduce((a, b) => i ? Math.max(a, b) : Math.min(a, b), all[0] ?? 0));
  image.canvas = Object.assign(document.createElement('canvas'), {width, height});
  const to = image.canvas.getContext('2d'), pixels = to.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    pixels.data.set(colorOf(name, Array.from(values.subarray(i * channels, (i + 1) * channels)), image.range), 4 * i);
    pixels.data[4 * i + 3] = 255;
  }
  to.putImageData(pixels, 0, 0);
}

const size = () => images.color;
const corner = () => ({x: Math.round(canvas.width / 2 - view.x * view.zoom),
                       y: Math.round(canvas.height / 2 - view.y * view.zoom)});

// A share of the part of the picture that is seen.
function line() {
  const left = Math.max(corner().x, 0), right = Math.min(corner().x + size().width * view.zoom, canvas.width);
  return {left, right, x: Math.round(left + view.split * (right - left))};
}

function show() {
  const at = corner(), x = line().x;
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingEnabled = view.zoom < 1;
  for (const [name, from, to] of [['color', 0, x], [view.name, x, canvas.width]]) {
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, canvas.height);
    context.clip();
    context.drawImage(images[name].canvas, at.x, at.y, size().width * view.zoom, size().height * view.zoom);
    context.restore();
  }
  for (const [color, width] of [['rgb(0 0 0 / 70%)', 3], ['#fff', 1.5]]) {
    context.strokeStyle = color;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, canvas.height);
    context.stroke();
  }
  if (view.hover && view.zoom >= 4) {
    context.strokeStyle = '#ffd54a';
    context.strokeRect(at.x + view.hover.x * view.zoom - 1, at.y + view.hover.y * view.zoom - 1, view.zoom + 2, view.zoom + 2);
  }
  $('zoom').textContent = view.zoom >= 1 ? `× ${view.zoom}` : `÷ ${1 / view.zoom}`;
}

const figure = (value, digits = 4) => Number(value.toPrecision(digits)).toLocaleString('en', {maximumSignificantDigits: digits});
const TEXTS = {
  color: (value) => value.join('  '),
  normal: (value) => value.map((part) => part.toFixed(2)).join('  '),
  depth: ([value]) => value === 0 ? 'infinite' : figure(value),
  object: ([value]) => value === 0 ? 'none' : `${value}, ${data.objects[value] ?? 'object'}`,
  shadow: ([value]) => figure(value, 3),
  cost: ([value]) => figure(value, 5),
  samples: ([value]) => figure(value, 5),
  error: ([value]) => figure(value, 3),
};

function valueAt(name, x, y) {
  const {channels, width, values} = images[name];
  return Array.from(values.subarray((y * width + x) * channels, (y * width + x + 1) * channels));
}

function showValues() {
  const at = view.hover, {width, height} = size();
  const inside = at && at.x >= 0 && at.y >= 0 && at.x < width && at.y < height;
  const cell = (name, text) => {
    const made = document.createElement('div');
    made.append(Object.assign(document.createElement('dt'), {textContent: name}),
                Object.assign(document.createElement('dd'), {textContent: text, title: text}));
    made.dataset.view = name;
    made.className = name === view.name ? 'chosen' : '';
    return made;
  };
  $('values').replaceChildren(cell('x, y', inside ? `${at.x}, ${at.y}` : '–'),
      ...Object.keys(images).map((name) => cell(name, inside ? TEXTS[name](valueAt(name, at.x, at.y)) : '–')));
}

function choose(name) {
  view.name = name;
  for (const button of $('views').children) button.setAttribute('aria-checked', button.dataset.view === name);
  $('about').textContent = ABOUT[name];
  $('shown').textContent = name;
  const {range, channels} = images[name];
  const hasScale = channels === 1 && name !== 'object';
  $('legend').style.visibility = hasScale ? '' : 'hidden';
  if (hasScale) {
    const isLog = name === 'samples' || name === 'cost';
    const [least, most] = name === 'depth' ? range : [isLog ? 1 : 0, name === 'shadow' ? 1 : range[1]];
    $('least').textContent = figure(least, 3);
    $('most').textContent = figure(most, 3);
    const scale = $('legend').querySelector('canvas').getContext('2d');
    for (let i = 0; i < 256; ++i) {
      const value = isLog ? 2 ** (Math.log2(most) * i / 255) : least + (most - least) * i / 255;
      scale.fillStyle = `rgb(${colorOf(name, [value], range).map(Math.round)})`;
      scale.fillRect(i, 0, 1, 1);
    }
  }
  show();
  showValues();
}

function fit() {
  const {width, height} = size(), most = Math.min(canvas.width / width, canvas.height / height);
  Object.assign(view, {zoom: ZOOMS.findLast((zoom) => zoom <= most) ?? ZOOMS[0], x: width / 2, y: height / 2, fitted: true});
  show();
}

function moveTo(x, y) {
  view.x = Math.min(Math.max(x, 0), size().width);
  view.y = Math.min(Math.max(y, 0), size().height);
  view.fitted = false;
  show();
}

// The point at `at`, by default the middle, stays.
function zoomBy(steps, at = {x: canvas.width / 2, y: canvas.height / 2}) {
  const before = view.zoom;
  view.zoom = ZOOMS[Math.min(Math.max(ZOOMS.indexOf(before) + steps, 0), ZOOMS.length - 1)];
  const scale = 1 / before - 1 / view.zoom;
  moveTo(view.x + (at.x - canvas.width / 2) * scale, view.y + (at.y - canvas.height / 2) * scale);
}

function setSplit(split) {
  view.split = $('split').value = Math.min(Math.max(split, 0), 1);
  show();
}

function listen() {
  const pointOf = (event) => ({x: event.offsetX * devicePixelRatio, y: event.offsetY * devicePixelRatio});
  const isAtLine = (point) => Math.abs(point.x - line().x) < 12 * devicePixelRatio;
  let drag = null;
  canvas.onpointerdown = (event) => {
    drag = {point: pointOf(event), x: view.x, y: view.y, isLine: isAtLine(pointOf(event))};
    canvas.setPointerCapture(event.pointerId);
  };
  canvas.onpointermove = (event) => {
    const point = pointOf(event), at = corner(), {left, right} = line();
    canvas.style.cursor = (drag?.isLine ?? isAtLine(point)) ? 'ew-resize' : drag ? 'grabbing' : '';
    view.hover = {x: Math.floor((point.x - at.x) / view.zoom), y: Math.floor((point.y - at.y) / view.zoom)};
    if (drag?.isLine) setSplit((point.x - left) / (right - left));
    else if (drag) moveTo(drag.x - (point.x - drag.point.x) / view.zoom, drag.y - (point.y - drag.point.y) / view.zoom);
    else show();
    showValues();
  };
  canvas.onpointerup = canvas.onpointercancel = () => { drag = null; };
  canvas.onpointerleave = () => {
    view.hover = null;
    show();
    showValues();
  };
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    if (event.deltaY !== 0) zoomBy(event.deltaY < 0 ? 1 : -1, pointOf(event));
  }, {passive: false});
  $('split').oninput = () => setSplit(Number($('split').value));
  $('larger').onclick = () => zoomBy(1);
  $('smaller').onclick = () => zoomBy(-1);
  $('fit').onclick = fit;
  const pan = (x, y) => moveTo(view.x + x * canvas.width / 8 / view.zoom, view.y + y * canvas.height / 8 / view.zoom);
  const keys = {'+': () => zoomBy(1), '=': () => zoomBy(1), '-': () => zoomBy(-1), '0': fit,
                ',': () => setSplit(view.split - 0.02), '.': () => setSplit(view.split + 0.02),
                ArrowLeft: () => pan(-1, 0), ArrowRight: () => pan(1, 0), ArrowUp: () => pan(0, -1), ArrowDown: () => pan(0, 1)};
  Object.keys(ABOUT).forEach((name, i) => { keys[i + 1] = () => choose(name); });
  document.addEventListener('keydown', (event) => {
    const own = event.target.matches('input') && event.key.startsWith('Arrow');
    if (event.ctrlKey || event.metaKey || event.altKey || own || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}

function resize() {
  canvas.width = Math.round(pane.clientWidth * devicePixelRatio);
  canvas.height = Math.round(pane.clientHeight * devicePixelRatio);
  if (view.fitted) fit();
  else show();
}

async function begin() {
  const names = Object.keys(data.views);
  const decoded = await Promise.all(names.map(decode));
  names.forEach((name, i) => { images[name] = decoded[i]; });
  names.forEach(draw);
  $('how').textContent = data.how;
  for (const name of Object.keys(ABOUT)) {
    const button = Object.assign(document.createElement('button'), {textContent: name});
    button.setAttribute('role', 'radio');
    button.dataset.view = name;
    button.onclick = () => { choose(name); button.blur(); };
    $('views').append(button);
  }
  listen();
  resize();
  choose(view.name);
  new ResizeObserver(resize).observe(pane);
  document.body.dataset.ready = 'yes';
}
begin();
