// Views, keys and mouse.

const VIEWS = {side: ['image', 'reference', 'third'], slider: ['slider'], flicker: ['flicker'],
               difference: ['difference'], flip: ['flip']};
const CAPTIONS = {image: 'actual', reference: 'reference', difference: 'difference', flip: 'FLIP'};
const FLICKER_MS = 600;
let flickering = null;

function legendOf(kind) {
  const largest = Math.max(view.pair.difference?.color.largest ?? 0, view.pair.difference?.alpha?.largest ?? 0);
  const scale = element('canvas', '');
  scale.width = 256;
  scale.height = 1;
  const context = scale.getContext('2d');
  for (let i = 0; i < 256; ++i) {
    context.fillStyle = kind === 'flip' ? `rgb(${palette.slice(3 * i, 3 * i + 3)})` : `rgb(${i},${i},${i})`;
    context.fillRect(i, 0, 1, 1);
  }
  return element('div', 'legend', '0', scale, kind === 'flip' ? '1' : `${figure(largest / view.brighter)} / 255`);
}

function messageFor(kind) {
  if (kind === 'image' || kind === 'reference') {
    return view.pictures[kind] ? '' : `There is no ${CAPTIONS[kind]} picture.`;
  }
  if (view.pair.equal) return kind === 'slider' || kind === 'flicker' ? '' : 'The pictures are equal.';
  if (view.pictures.difference) return '';
  return view.pair.verdict === 'sizes differ' ? 'Pictures of different size are not compared.' :
                                                'There is only one picture.';
}

// The panes of the view.
function layOut() {
  const kinds = VIEWS[view.name].map((kind) => kind === 'third' ? view.third : kind);
  surfaces = [];
  const made = kinds.map((kind) => {
    const canvas = element('canvas', '');
    const pane = element('div', 'pane', canvas);
    const caption = (text, side = '') => pane.append(element('span', `caption ${side}`, text));
    if (kind === 'slider') {
      caption('actual');
      caption('reference', 'right');
    } else {
      caption(CAPTIONS[kind === 'flicker' ? view.shown : kind]);
    }
    const message = messageFor(kind);
    if (message) pane.append(element('span', 'message', message));
    else if (kind === 'difference' || kind === 'flip') pane.append(legendOf(kind));
    surfaces.push({canvas, context: canvas.getContext('2d'), kind, pane});
    listen(canvas, kind);
    return pane;
  });
  panes.replaceChildren(...made);
  for (const button of document.querySelectorAll('#views button')) {
    button.setAttribute('aria-checked', button.dataset.view === view.name);
  }
  showControl();
  resize();
}

function resize() {
  const first = surfaces[0]?.pane;
  if (!first) return;
  for (const {canvas, pane} of surfaces) {
    // All of one size, so that the pictures stand at the same place in each.
    canvas.width = Math.round(first.clientWidth * devicePixelRatio);
    canvas.height = Math.round(first.clientHeight * devicePixelRatio);
    canvas.style.width = `${canvas.width / devicePixelRatio}px`;
    canvas.style.height = `${canvas.height / devicePixelRatio}px`;
    pane.dataset.ready = 'yes';
  }
  if (view.fitted) fit();
  else draw();
}

function setView(name) {
  view.name = name;
  clearInterval(flickering);
  flickering = null;
  if (!view.pictures) return;
  layOut();
  if (name === 'flicker') flicker();
}

function flicker() {
  clearInterval(flickering);
  flickering = setInterval(swap, FLICKER_MS);
  showControl();
}

function swap() {
  view.shown = view.shown === 'image' ? 'reference' : 'image';
  panes.querySelector('.caption').textContent = CAPTIONS[view.shown];
  draw();
}

// The first press stops, the others swap.
function stopOrSwap() {
  if (flickering === null) return swap();
  clearInterval(flickering);
  flickering = null;
  showControl();
}

function setSplit(split) {
  view.split = Math.min(Math.max(split, 0), 1);
  const slider = $('split');
  if (slider) slider.value = view.split;
  draw();
}

function showControl() {
  const control = $('control');
  control.replaceChildren();
  if (view.name === 'slider') {
    const slider = element('input', '');
    Object.assign(slider, {id: 'split', type: 'range', min: 0, max: 1, step: 0.001, value: view.split});
    slider.setAttribute('aria-label', 'Share of the actual picture');
    slider.oninput = () => setSplit(Number(slider.value));
    control.append(slider);
  } else if (view.name === 'flicker') {
    const button = element('button', '', flickering === null ? 'Go on' : 'Stop');
    button.onclick = () => flickering === null ? flicker() : stopOrSwap();
    control.append(element('div', 'flicker', button, 'Space stops and swaps, Enter goes on'));
  } else if (view.name === 'side') {
    // The third picture is chosen by a key or by a click on its name.
    const caption = panes.lastChild.querySelector('.caption');
    caption.textContent = `${CAPTIONS[view.third]} (d: ${CAPTIONS[view.third === 'flip' ? 'difference' : 'flip']})`;
  }
}

function swapThird() {
  if (view.name !== 'side') return;
  view.third = view.third === 'flip' ? 'difference' : 'flip';
  layOut();
}

// So that the pane's white stands for a fourth or a sixteenth of the largest difference.
function brighten() {
  view.brighter = view.brighter === 16 ? 1 : 4 * view.brighter;
  layOut();
}

function goToLargest() {
  if (!view.pair.largest) return;
  view.zoom = Math.max(view.zoom, 16);
  moveTo(view.pair.largest.x + 0.5, view.pair.largest.y + 0.5);
}

// In device pixels of the pane.
const pointOf = (event) => ({x: event.offsetX * devicePixelRatio, y: event.offsetY * devicePixelRatio});

function listen(canvas, kind) {
  let drag = null;
  const isAtLine = (point) => kind === 'slider' && Math.abs(point.x - sliderLine().x) < 12 * devicePixelRatio;
  canvas.onpointerdown = (event) => {
    const point = pointOf(event);
    drag = {point, x: view.x, y: view.y, isLine: isAtLine(point)};
    canvas.setPointerCapture(event.pointerId);
  };
  canvas.onpointermove = (event) => {
    const point = pointOf(event), at = corner();
    canvas.style.cursor = drag ? (drag.isLine ? 'ew-resize' : 'grabbing') : isAtLine(point) ? 'ew-resize' : '';
    if (drag?.isLine) {
      const line = sliderLine();
      setSplit((point.x - line.left) / (line.right - line.left));
    } else if (drag) {
      moveTo(drag.x - (point.x - drag.point.x) / view.zoom, drag.y - (point.y - drag.point.y) / view.zoom);
    }
    view.hover = {x: Math.floor((point.x - at.x) / view.zoom), y: Math.floor((point.y - at.y) / view.zoom)};
    draw();
    showReadout();
  };
  canvas.onpointerup = canvas.onpointercancel = () => { drag = null; };
  canvas.onpointerleave = () => {
    view.hover = null;
    draw();
    showReadout();
  };
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    if (event.deltaY !== 0) zoomBy(event.deltaY < 0 ? 1 : -1, pointOf(event));
  }, {passive: false});
}

function valueText(image, values) {
  return values.map((value, i) => {
    const maximum = image.maxima[i] || (i === 3 ? image.maxima[0] : 0);
    return maximum > 0 ? Math.round(value * maximum) : Number.isFinite(value) ? Number(value.toPrecision(5)) : value;
  }).join('  ');
}

// The values under the mouse, or else at the largest difference.
function showReadout() {
  const at = view.hover ?? view.pair.largest;
  const cells = [element('span', '', element('b', '', 'x, y '), at ? `${at.x}, ${at.y}` : '')];
  const found = {};
  for (const [name, image] of [['image', view.pair.image], ['reference', view.pair.reference]]) {
    const values = at && valuesAt(name, at.x, at.y);
    found[name] = values;
    const cell = element('span', '', element('b', '', CAPTIONS[name] + ' '));
    if (values) {
      const swatch = element('span', 'swatch');
      swatch.style.background = `rgb(${bytesAt(view.pictures[name], at.x, at.y).slice(0, 3)})`;
      cell.append(swatch, valueText(image, values));
    }
    cells.push(cell);
  }
  const {image, reference} = found;
  // Without alpha a picture is opaque.
  const distance = (_, i) => figure(255 * Math.abs((image[i] ?? 1) - (reference[i] ?? 1)));
  const differences = image && reference && view.pair.difference &&
                      Array.from({length: Math.max(image.length, reference.length)}, distance);
  cells.push(element('span', '', element('b', '', 'difference / 255 '), differences ? differences.join('  ') : ''));
  const map = view.pictures.flip;
  const flip = image && map ? figure(bytesAt(map.grey, at.x, at.y)[0] / 255) : '';
  cells.push(element('span', '', element('b', '', 'FLIP '), flip));
  $('readout').replaceChildren(...cells);
}

// By eighths of a pane.
function pan(x, y) {
  const {width, height} = paneSize();
  moveTo(view.x + x * width / 8 / view.zoom, view.y + y * height / 8 / view.zoom);
}

const KEYS = {
  j: () => step(1), k: () => step(-1), d: swapThird, g: goToLargest, b: brighten, '0': fit,
  '+': () => zoomBy(1), '=': () => zoomBy(1), '-': () => zoomBy(-1),
  ',': () => setSplit(view.split - 0.02), '.': () => setSplit(view.split + 0.02),
  m: () => { view.ring = !view.ring; draw(); },
  ' ': () => view.name === 'flicker' && stopOrSwap(),
  Enter: () => view.name === 'flicker' && flicker(),
  ArrowLeft: () => pan(-1, 0), ArrowRight: () => pan(1, 0), ArrowUp: () => pan(0, -1), ArrowDown: () => pan(0, 1),
  '/': () => $('filter').focus(), '?': () => $('keys').showModal(),
};
Object.keys(VIEWS).forEach((name, i) => { KEYS[i + 1] = () => setView(name); });

document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || $('keys').open) return;
  const typing = event.target.matches('input[type=search]');
  if (typing && event.key === 'Escape') event.target.blur();
  // A range input moves by arrows, a button is pressed by Space and Enter.
  const own = typing || (event.target.matches('input[type=range]') && event.key.startsWith('Arrow')) ||
              (event.target.matches('button') && (event.key === ' ' || event.key === 'Enter'));
  if (own || !KEYS[event.key] || !view.pair) return;
  event.preventDefault();
  KEYS[event.key]();
});

for (const button of document.querySelectorAll('#views button')) {
  button.onclick = () => {
    setView(button.dataset.view);
    button.blur();  // so that Space and Enter are the view's
  };
}
$('larger').onclick = () => zoomBy(1);
$('smaller').onclick = () => zoomBy(-1);
$('fit').onclick = fit;
$('help').onclick = () => $('keys').showModal();
$('filter').oninput = $('failing').onchange = showList;
new ResizeObserver(resize).observe(panes);

showSummary();
const named = () => pairs.find((pair) => pair.name === decodeURIComponent(location.hash.slice(1)));
window.onhashchange = () => named() && named() !== view.pair && choose(named());
const asked = named();
if (asked?.look === 'good') $('failing').checked = false;
showList();
if (pairs.length) choose(asked ?? listed[0]);
