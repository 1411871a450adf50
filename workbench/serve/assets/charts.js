// Measured and simulated output, residual and u over one time axis, zoomed together.
import {colour, drawn, number} from './dom.js';
import {envelope, stretch} from './envelope.js';
import {Overview} from './overview.js';
import {language, say} from './texts.js';
import {picture} from './xy.js';

const HEIGHTS = {output: 240, residual: 110, u: 120};

const unitFor = span =>
  span < 600 ? [1, 's'] : span < 6 * 3600 ? [60, 'min']
    : span < 4 * 86400 ? [3600, 'h'] : [86400, say('days')];

// Clock times as the file writes them: the zone is left out, so that nothing is shifted.
const clockOf = start => start ? Date.parse(start.slice(0, 19) + 'Z') / 1000 : null;
const two = value => String(value).padStart(2, '0');
function clockText(seconds, withSeconds) {
  const d = new Date(Math.round(seconds * 1000));
  return `${two(d.getUTCHours())}:${two(d.getUTCMinutes())}` +
    (withSeconds ? `:${two(d.getUTCSeconds())}` : '');
}
const dayText = seconds => new Date(seconds * 1000)
  .toLocaleDateString(language, {day: 'numeric', month: 'short', timeZone: 'UTC'});

const withAlpha = (ink, alpha) =>
  ink + Math.round(255 * alpha).toString(16).padStart(2, '0');

// Half the width of the band that 95 % of the values lie in.
function spread(values) {
  const sizes = Float64Array.from(values, Math.abs).sort();
  return sizes[Math.floor(0.95 * (sizes.length - 1))];
}

export class Charts {
  constructor(box, strip) {
    this.box = box;
    this.overview = new Overview(strip, (min, max) => this.set(min, max));
    this.plots = [];
    this.data = null;
    this.onRange = () => {};
    new ResizeObserver(() => this.fit()).observe(box);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    box.addEventListener('keydown', event => {
      const what = {ArrowLeft: 'left', ArrowRight: 'right', '+': 'in', '=': 'in',
                    '-': 'out', '0': 'all'}[event.key];
      if (!what || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      this.zoom(what);
    });
  }

  // Signals as /api/signals gives them. Keeps the zoom where the time axis is the same.
  show(data, recording) {
    const same = this.data && this.data.t.length === data.t.length &&
      this.data.t[0] === data.t[0] && this.data.t.at(-1) === data.t.at(-1);
    if (!same) this.range = null;
    this.data = data;
    this.units = recording.units;
    this.clock = clockOf(recording.start);
    const [seconds, unit] = this.clock === null ? unitFor(data.t.at(-1) - data.t[0]) : [1, ''];
    this.seconds = seconds;
    this.origin = this.clock === null ? 0 : data.t[0] - this.clock;
    this.label = this.clock === null ? say('time, {0}', unit) : say('clock time');
    this.t = data.t.map(t => (t - this.origin) / seconds);
    this.draw();
  }

  // Outputs of other models, drawn over the present one: [{label, ink, values}].
  others(lines) {
    if (!lines.length && !this.over?.length) return;
    this.over = lines;
    this.draw();
  }

  // All plots as they are seen, one above the other.
  png() {
    const ratio = devicePixelRatio, canvases = this.plots.map(({plot}) => plot.ctx.canvas);
    const head = 22 * ratio;
    const out = document.createElement('canvas');
    out.width = canvases[0].width;
    out.height = canvases.reduce((sum, c) => sum + c.height + head, 0);
    const ctx = out.getContext('2d');
    ctx.fillStyle = colour('card');
    ctx.fillRect(0, 0, out.width, out.height);
    let y = 0;
    ctx.font = `${12 * ratio}px system-ui, sans-serif`;
    this.plots.forEach(({lines}, i) => {
      let x = 56 * ratio;
      for (const {label, ink} of lines) {
        ctx.fillStyle = colour(ink);
        ctx.fillRect(x, y + 11 * ratio, 18 * ratio, 3 * ratio);
        ctx.fillStyle = colour('ink');
        ctx.fillText(label, x + 24 * ratio, y + 16 * ratio);
        x += ctx.measureText(label).width + 44 * ratio;
      }
      ctx.drawImage(canvases[i], 0, y + head);
      y += canvases[i].height + head;
    });
    return new Promise(done => out.toBlob(done, 'image/png'));
  }

  // The same as a picture of lines, with its style inside.
  svg() {
    const range = this.visible(), part = stretch(this.t, ...range);
    let y = 0, body = '';
    for (const {lines, axis, name} of this.plots) {
      const seen = envelope(this.t, lines.map(line => line.values), part, 900);
      const figure = picture({title: axis, xLabel: this.label, yLabel: axis, width: 1000,
        height: HEIGHTS[name] + 60,
        lines: lines.map((line, i) => ({label: line.label, ink: line.ink, x: seen.t, y: seen.signals[i].mean}))});
      const svg = figure.querySelector('svg');
      let x = 60;
      for (const {label, ink} of lines) {
        body += `<rect x="${x}" y="${y + 8}" width="18" height="3" fill="${colour(ink)}"/>` +
          `<text x="${x + 24}" y="${y + 14}" font-size="12">${label.replace(/[<&]/g, '')}</text>`;
        x += 40 + 7 * label.length;
      }
      for (const item of svg.querySelectorAll('path')) {
        const ink = lines.find(line => item.classList.contains(line.ink))?.ink;
        item.setAttribute('stroke', colour(ink ?? 'grid'));
        item.setAttribute('fill', 'none');
      }
      for (const item of svg.querySelectorAll('text')) item.setAttribute('font-size', '12');
      body += `<g transform="translate(0 ${y + 18})">${svg.innerHTML}</g>`;
      y += HEIGHTS[name] + 84;
    }
    const out = drawn('svg', {viewBox: `0 0 1000 ${y}`, width: 1000, height: y,
      'font-family': 'sans-serif', fill: colour('ink')});
    out.innerHTML = `<rect width="1000" height="${y}" fill="${colour('card')}"/>${body}`;
    return new XMLSerializer().serializeToString(out);
  }

  // Another simulated output in place of the model's, while parameters are tried.
  tryOut(simulated) {
    const {output, residual} = this.index;
    const d = this.data;
    output[this.index.simulated].values = simulated ?? d.simulated;
    if (residual) {
      residual[0].values = simulated ? simulated.map((s, k) => d.measured[k] - s) : d.residual;
    }
    this.refresh();
  }

  draw() {
    for (const {plot} of this.plots) plot.destroy();
    this.plots = [];
    if (!this.data) return;
    const d = this.data, y = d.output;
    const withUnit = name => this.units[name] ? `${name}, ${this.units[name]}` : name;
    const line = (label, ink, width, values, more = {}) => ({label, ink, width, values, more});
    const output = [line(say('measured {0}', y), 'measured', 2.2, d.measured)];
    if (d.sp) output.push(line(say('setpoint'), 'setpoint', 1, d.sp, {dash: [6, 4]}));
    this.index = {output, simulated: output.length};
    // 95 % of the residual lies in the band.
    const around = d.residual ? spread(d.residual) : 0;
    if (d.simulated) output.push(line(say('simulated {0}', y), 'valve', 1.5, d.simulated, {around}));
    for (const {label, ink, values} of this.over ?? []) output.push(line(label, ink, 1.3, values));
    this.add('output', withUnit(y), output);
    if (d.residual) {
      this.index.residual = [line(say('residual'), 'linear', 1.2, d.residual)];
      this.add('residual', say('residual'), this.index.residual);
    }
    this.add('u', withUnit('u'), [line(say('controller output u'), 'two-path', 1.3, d.u)], this.label);
    this.refresh();
  }

  text(value, digits = 5) {
    return value == null ? '–' : number(value, digits);
  }

  add(name, axis, lines, timeLabel = null) {
    const text = colour('soft'), grid = {stroke: colour('grid'), width: 1};
    const font = '12px system-ui, sans-serif';
    const clock = this.clock !== null;
    const series = [], bands = [];
    for (const {label, ink, width, more} of lines) {
      const stroke = colour(ink), at = series.length + 1;
      series.push({label, stroke, width, points: {show: false},
        value: (_, v) => this.text(v), ...more});
      for (const edge of ['low', 'high']) {
        series.push({label: edge, class: 'edge', width: 0, points: {show: false}});
      }
      bands.push({series: [at + 2, at + 1], fill: withAlpha(stroke, more.around ? 0.18 : 0.3)});
    }
    const times = (u, splits, _, __, by) => splits.map((v, i) => !clock ? this.text(v, 6)
      : by >= 86400 || i === 0 && by >= 60 || v % 86400 === 0 ? dayText(v) + (by >= 86400 ? '' : ' ' + clockText(v, false))
        : clockText(v, by < 60));
    const plot = new uPlot({
      width: Math.max(this.box.clientWidth, 200),
      height: HEIGHTS[name] + (timeLabel ? 44 : 0),
      cursor: {sync: {key: 'stickband'}, y: false, drag: {x: true, y: false, setScale: false},
               points: {size: 6}, bind: {dblclick: () => () => { this.zoom('all'); }}},
      legend: {live: true},
      scales: {x: {time: clock, range: () => this.visible()}},
      tzDate: seconds => uPlot.tzDate(new Date(seconds * 1000), 'Etc/UTC'),
      bands,
      series: [{label: clock ? say('time') : this.label.replace(/^[^,]*/, 't'),
                value: (_, v) => v == null ? '–' : clock ? clockText(v, true) : this.text(v)},
               ...series],
      axes: [
        {stroke: text, grid, ticks: grid, font, labelFont: font, space: clock ? 90 : 50,
         label: timeLabel ?? undefined, labelSize: 20, size: timeLabel ? 28 : 8,
         values: timeLabel ? times : () => []},
        {stroke: text, grid, ticks: grid, font, labelFont: font, label: axis,
         labelSize: 18, size: 52, space: 22,
         values: (_, splits) => splits.map(v => this.text(v, 6))},
      ],
      hooks: {
        setSelect: [self => this.selected(self)],
        drawClear: [self => this.mark(self, name)],
      },
    }, [[0, 1], ...series.map(() => [null, null])], this.box);
    this.plots.push({plot, lines, axis, name});
  }

  // Below the output which samples were fitted; behind u and output what to beware of.
  mark(plot, name) {
    const {ctx, bbox} = plot, d = this.data;
    const at = seconds => plot.valToPos((seconds - this.origin) / this.seconds, 'x', true);
    const clip = x => Math.min(Math.max(x, bbox.left), bbox.left + bbox.width);
    const box = (from, to, top, height, ink) => {
      const left = clip(at(from)), right = clip(at(to));
      if (right <= left) return;
      ctx.fillStyle = ink;
      ctx.fillRect(left, top, right - left, height);
    };
    ctx.save();
    for (const [from, to, kind] of d.marks) {
      const here = kind === 'limit' || kind === 'rest' ? name === 'u' : name === 'output';
      if (here) box(from, to, bbox.top, bbox.height, withAlpha(colour('open'), 0.22));
    }
    if (name === 'residual') {
      const thick = 5 * devicePixelRatio;
      for (const [from, to, fitted] of d.blocks) {
        box(from, to, bbox.top + bbox.height - thick, thick, colour(fitted ? 'usual' : 'two-path'));
      }
    }
    ctx.restore();
  }

  whole() {
    return [this.t[0], this.t.at(-1)];
  }

  visible() {
    return this.range ?? this.whole();
  }

  // All plots at what is to be seen.
  refresh() {
    const range = this.visible();
    const part = stretch(this.t, ...range);
    for (const {plot, lines} of this.plots) {
      const pixels = Math.max(Math.round(plot.bbox.width / devicePixelRatio), 100);
      const seen = envelope(this.t, lines.map(line => line.values), part, pixels);
      const data = [seen.t];
      seen.signals.forEach(({mean, low, high}, i) => {
        const around = lines[i].more.around ?? 0;
        const [from, to] = seen.dense ? [low, high] : around ? [mean, mean] : [null, null];
        const edge = (values, by) => values ? values.map(v => v + by) : mean.map(() => null);
        data.push(mean, edge(from, -around), edge(to, around));
      });
      plot.setData(data, true);
    }
    this.overview.draw(this.t, this.data.measured, range);
  }

  selected(plot) {
    const {left, width} = plot.select;
    if (width < 3) return;
    const from = plot.posToVal(left, 'x'), to = plot.posToVal(left + width, 'x');
    for (const other of this.plots) other.plot.setSelect({left: 0, width: 0, top: 0, height: 0}, false);
    this.set(from, to);
  }

  set(min, max) {
    const [first, last] = this.whole();
    const width = Math.min(Math.max(max - min, (last - first) / 20000), last - first);
    const start = Math.min(Math.max((min + max - width) / 2, first), last - width);
    const all = width >= last - first;
    this.range = all ? null : [start, start + width];
    this.refresh();
    this.onRange(this.seconds_(), all);
  }

  // What is seen, in seconds as in the answers of the API.
  seconds_() {
    return this.visible().map(v => v * this.seconds + this.origin);
  }

  // Seconds, as in the answers of the API, with some room around.
  lookAt(from, to) {
    const room = Math.max((to - from) * 0.6, 0);
    this.set((from - room - this.origin) / this.seconds, (to + room - this.origin) / this.seconds);
  }

  zoom(what) {
    if (!this.plots.length) return;
    const [min, max] = this.visible(), width = max - min;
    if (what === 'all') this.set(...this.whole());
    if (what === 'in') this.set(min + width / 4, max - width / 4);
    if (what === 'out') this.set(min - width / 2, max + width / 2);
    if (what === 'left') this.set(min - width / 4, max - width / 4);
    if (what === 'right') this.set(min + width / 4, max + width / 4);
  }

  fit() {
    let changed = false;
    for (const {plot} of this.plots) {
      if (plot.width === this.box.clientWidth || !this.box.clientWidth) continue;
      plot.setSize({width: this.box.clientWidth, height: plot.height});
      changed = true;
    }
    if (changed) this.refresh();
  }
}
