// The page around the pictures: the list, the numbers, keys and mouse.

const $ = (id) => document.getElementById(id);
const pairs = Array.from(document.querySelectorAll('script.pair'), (script, number) => {
  const pair = JSON.parse(script.textContent);
  const of = pair.difference;
  const largest = of && (of.alpha?.largest > of.color.largest ? of.alpha : of.color);
  return Object.assign(pair, {
    number,
    equal: Boolean(of) && of.histogram[0].pixels === of.pixels,
    largest: of?.unlike ? {x: of.unlikeX, y: of.unlikeY} : largest?.largest > 0 ? largest : null,
    words: pair.verdict.replace('image', 'actual'),
    look: {alike: 'good', differs: 'bad', 'sizes differ': 'bad'}[pair.verdict] ?? 'odd',
  });
});
const listed = [...pairs].sort((a, b) => (a.look === 'good') - (b.look === 'good') || a.number - b.number);
const count = (number) => number.toLocaleString('en');
const figure = (number) => number === null ? 'infinite' : number === 0 ? '0' : String(Number(number.toPrecision(4)));

function element(tag, className, ...children) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...children);
  return made;
}

function showSummary() {
  for (const look of ['bad', 'odd', 'good']) {
    const some = pairs.filter((pair) => pair.look === look).length;
    const words = {bad: some === 1 ? 'differs' : 'differ', odd: 'missing or unreadable', good: 'alike'};
    if (some) $('summary').append(element('span', look, `${count(some)} ${words[look]}`));
  }
  const good = pairs.filter((pair) => pair.look === 'good').length;
  $('failing').checked = good > 0 && good < pairs.length;
  $('failing').parentNode.hidden = good === 0 || good === pairs.length;
}

const visible = () => listed.filter((pair) => (!$('failing').checked || pair.look !== 'good') &&
                                              pair.name.toLowerCase().includes($('filter').value.toLowerCase()));

function shareText(pair) {
  const of = pair.difference;
  if (!of) return pair.words;
  if (pair.equal) return 'equal';
  const percent = 100 * of.differing / of.pixels;
  if (percent < 0.1) return `${of.differing} px`;
  return `${percent < 10 ? percent.toPrecision(2) : Math.round(percent)} %`;
}

function showList() {
  const rows = visible().map((pair) => {
    const row = element('button', '', element('span', `dot ${pair.look}`), element('span', 'name', pair.name),
                        element('span', 'share', shareText(pair)));
    row.title = pair.name;
    row.setAttribute('aria-current', pair === view.pair);
    row.onclick = () => choose(pair);
    pair.row = row;
    return element('li', '', row);
  });
  $('list').replaceChildren(...(rows.length ? rows : [element('li', 'none', 'No pair has such a name.')]));
}

function step(by) {
  const among = visible();
  const next = among[Math.min(Math.max(among.indexOf(view.pair) + by, 0), among.length - 1)];
  if (next) choose(next);
}

async function choose(pair) {
  view.pair?.row?.setAttribute('aria-current', false);
  view.pair = pair;
  pair.row?.setAttribute('aria-current', true);
  pair.row?.scrollIntoView({block: 'nearest'});
  view.hover = null;
  $('name').textContent = $('name').title = pair.name;
  $('verdict').textContent = pair.words;
  $('verdict').className = pair.look;
  showNumbers(pair);
  showHistogram(pair);
  showFiles(pair);
  location.replace('#' + encodeURIComponent(pair.name));
  const before = pictureSize(), had = view.pictures;
  const pictures = await picturesOf(pair);
  if (view.pair !== pair) return;  // another was chosen meanwhile
  view.pictures = pictures;
  const size = pictureSize();
  layOut();
  if (!had || view.fitted || size.width !== before.width || size.height !== before.height) fit();
  showReadout();
}

function showNumbers(pair) {
  const of = pair.difference, limits = pair.limits;
  const table = $('numbers');
  table.replaceChildren();
  const row = (name, value, limit, exceeded) => {
    const cells = [element('th', '', name), element('td', '', ...[value].flat())];
    if (limit) cells.push(element('td', exceeded ? 'limit bad' : 'limit', limit));
    else cells[1].colSpan = 2;
    table.append(element('tr', '', ...cells));
  };
  if (!of) return row('Not compared', pair.problem ?? (pair.verdict === 'sizes differ' ?
      `${sizeText(pair.image)} and ${sizeText(pair.reference)}` : pair.words));
  const counted = limits.tolerance !== null || limits.maxDiffering !== null ||
                  (limits.maxRmse === null && limits.maxFlip === null);
  const most = limits.maxDiffering ?? 0;
  row('Differing pixels', `${count(of.differing)} of ${count(of.pixels)}`,
      counted ? `allowed ${count(most)}` + (limits.tolerance ? ` by over ${limits.tolerance}` : '') : null,
      of.differing > most);
  const there = pair.largest ? [element('button', '', 'Go there')] : [];
  if (there.length) there[0].onclick = goToLargest;
  const levels = ({largest, x, y}) => `${figure(largest)} / 255` + (largest > 0 ? ` at ${x},${y}` : '');
  row('Largest difference', [levels(of.color), ...there]);
  const allowed = (limit) => limit === null ? null : `allowed ${limit}`;
  row('RMSE', figure(of.rmse), allowed(limits.maxRmse), of.rmse > limits.maxRmse);
  row('PSNR', of.psnr === null ? 'infinite' : `${figure(of.psnr)} dB`);
  row('FLIP mean', figure(of.meanFlip), allowed(limits.maxFlip), of.meanFlip > limits.maxFlip);
  if (of.alpha) row('Alpha', `${count(of.alpha.differing)} differ, largest ${levels(of.alpha)}`);
  if (of.finite < of.pixels) row('Not finite', `${count(of.unlike)} differ`, 'allowed 0', of.unlike > 0);
}

function showHistogram(pair) {
  $('distribution').hidden = !pair.difference;
  if (!pair.difference) return;
  const {histogram, pixels} = pair.difference;
  const short = new Intl.NumberFormat('en', {notation: 'compact', maximumSignificantDigits: 2});
  const bars = histogram.map(({upTo, pixels: some}, i) => {
    const label = upTo === 0 ? 'equal' : upTo === null ? 'more' : `≤${upTo}`;
    const bar = element('i', '');
    bar.style.height = some ? `${Math.max(2, 84 * Math.log(some + 1) / Math.log(pixels + 1))}px` : '0';
    if (i === 0) bar.style.opacity = 0.35;
    const column = element('div', '', element('span', '', some ? short.format(some) : ''), bar,
                           element('span', 'label', label));
    column.title = `${label}: ${count(some)} pixels; the height is logarithmic`;
    return column;
  });
  $('histogram').replaceChildren(...bars);
}

const sizeText = (image) => image?.width ? `${image.width} × ${image.height}` : '';

function showFiles(pair) {
  const rows = [];
  const row = (name, text, title = '') => {
    const value = element('dd', '', text);
    value.title = title;
    rows.push(element('dt', '', name), value);
  };
  // Of a long path the last two names are shown, and all of it under the mouse.
  const short = (file) => file.length < 32 ? file : file.split('/').slice(-2).join('/');
  for (const [name, image] of [['Actual', pair.image], ['Reference', pair.reference]]) {
    const parts = image ? [short(image.file), sizeText(image), image.format] : ['missing'];
    row(name, parts.filter(Boolean).join(', '), image?.file);
  }
  const driver = pair.driver || pair.image?.device;
  if (driver) row('Driver', driver);
  if (pair.comparedAs) row('Compared as', pair.comparedAs);
  for (const note of pair.image?.notes ?? []) row('Note', `the actual picture ${note}`);
  for (const note of pair.reference?.notes ?? []) row('Note', `the reference ${note}`);
  $('files').replaceChildren(...rows);
}
