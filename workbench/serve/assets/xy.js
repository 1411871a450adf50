// Small pictures with any two axes, as SVG in the style of the report.
import {drawn, element, number} from './dom.js';
import {extent} from './envelope.js';

const LEFT = 50, RIGHT = 10, TOP = 10, BOTTOM = 40;

const step = (span, count) => {
  const rough = span / count, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find(f => f * power >= rough);
};

function roomy(lists) {
  const [low, high] = extent(lists), room = (high - low || 1) * 0.04;
  return [low - room, high + room];
}

// Of a range that numbers can hardly divide its lower end alone.
const ticks = ([low, high], count) => {
  if (!(high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)))) return [low];
  const by = step(high - low, count), out = [];
  for (let k = Math.ceil(low / by); k * by <= high; ++k) out.push(Number((k * by).toPrecision(12)));
  return out;
};

// A figure: legend, picture, caption. lines: {label, ink, x, y, broad}; labels are shown
// where there is more than one line.
export function picture({title, xLabel, yLabel, lines, caption, width: WIDTH = 330, height = 220}) {
  const xs = roomy(lines.map(line => line.x)), ys = roomy(lines.map(line => line.y));
  const px = x => LEFT + (x - xs[0]) / (xs[1] - xs[0]) * (WIDTH - LEFT - RIGHT);
  const py = y => height - BOTTOM - (y - ys[0]) / (ys[1] - ys[0]) * (height - TOP - BOTTOM);
  const grid = drawn('g', {class: 'grid'}), words = drawn('g', {class: 'ticks'});
  const text = (value, attributes) => {
    const out = drawn('text', attributes);
    out.textContent = value;
    words.append(out);
  };
  for (const x of ticks(xs, 5)) {
    grid.append(drawn('path', {d: `M${px(x)} ${TOP}V${height - BOTTOM}`}));
    text(number(x, 5), {x: px(x), y: height - BOTTOM + 16, 'text-anchor': 'middle'});
  }
  for (const y of ticks(ys, 5)) {
    grid.append(drawn('path', {d: `M${LEFT} ${py(y)}H${WIDTH - RIGHT}`}));
    text(number(y, 5), {x: LEFT - 6, y: py(y) + 4, 'text-anchor': 'end'});
  }
  text(xLabel, {x: (LEFT + WIDTH - RIGHT) / 2, y: height - 6, 'text-anchor': 'middle', class: 'axis'});
  text(yLabel, {x: 12, y: (TOP + height - BOTTOM) / 2, 'text-anchor': 'middle', class: 'axis',
    transform: `rotate(-90 12 ${(TOP + height - BOTTOM) / 2})`});
  const svg = drawn('svg', {viewBox: `0 0 ${WIDTH} ${height}`, role: 'img', 'aria-label': title},
    grid, words);
  for (const line of lines) {
    let d = '', pen = 'M';
    if (line.dots) {
      line.x.forEach((x, i) => { d += `M${px(x).toFixed(1)} ${py(line.y[i]).toFixed(1)}h0`; });
      svg.append(drawn('path', {class: `line dots ${line.ink}`, d}));
      continue;
    }
    line.x.forEach((x, i) => {
      if (x == null || line.y[i] == null) {
        pen = 'M';
        return;
      }
      d += `${pen}${px(x).toFixed(1)} ${py(line.y[i]).toFixed(1)}`;
      pen = 'L';
    });
    svg.append(drawn('path', {class: `line ${line.ink}${line.broad ? ' thick' : ''}`, d}));
  }
  const out = element('figure', {className: 'xy'}, element('h3', {textContent: title}));
  if (lines.length > 1) {
    out.append(element('div', {className: 'legend'}, ...lines.map(line =>
      element('span', {}, element('i', {className: line.ink}), line.label))));
  }
  out.append(svg);
  if (caption) out.append(element('figcaption', {textContent: caption}));
  return out;
}
