// Measured and simulated output, residual and u over one time axis, zoomed together.
import {colour, drawn, number, withUnit} from './dom.js';
import {envelope, extent, stretch} from './envelope.js';
import {drawLine} from './lines.js';
import {Overview} from './overview.js';
import {Shading} from './shading.js';
import {say} from './texts.js';
import {clockOf, clockText, dayText, unitFor} from './times.js';
import {picture} from './xy.js';

const HEIGHTS = {output: 240, residual: 130, u: 120};

// Half the width of the band that 95 % of the values lie in.
function spread(values) {
  const sizes = Float64Array.from(values.filter(value => value !== null), Math.abs).sort();
  return sizes[Math.floor(0.95 * (sizes.length - 1))];
}

export class Charts {
  constructor(box, strip) {
    this.box = box;
    this.overview = new Overview(strip, (min, max) => this.set(min, max));
    this.shading = new Shading(seconds => (seconds - this.origin) / this.seconds);
    this.plots = [];
    this.over = {};
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

  // Signals as /api/signals gives them; `inks` of the recordings that are joined in them.
  // Keeps the zoom where the time axis is the same.
  show(data, recording, inks) {
    const same = this.data && this.data.t.length === data.t.length &&
      this.data.t[0] === data.t[0] && this.data.t.at(-1) === data.t.at(-1);
    if (!same) this.range = null;
    this.data = data;
    this.inks = inks;
    data.residual &&= this.without(data.residual);
    this.units = recording.units;
    this.clock = clockOf(recording.start);
    const [seconds, unit] = this.clock === null ? unitFor(data.t.at(-1) - data.t[0]) : [1, ''];
    this.seconds = seconds;
    this.origin = this.clock === null ? 0 : data.t[0] - this.clock;
    this.label = this.clock !== null ? say('clock time')
      : data.pieces.length ? say('time, {0}, the recordings one after the other', unit) : say('time, {0}', unit);
    this.t = data.t.map(t => (t - this.origin) / seconds);
    this.draw();
  }

  // Nothing is said where samples are left out.
  without(values) {
    const {t, left_out: apart} = this.data;
    return apart.length ? values.map((value, k) =>
      apart.some(([from, to]) => t[k] >= from && t[k] <= to) ? null : value) : values;
  }

  // What was measured, each recording in its own colour.
  measured() {
    const {pieces, measured, t, output} = this.data, names = [...new Set(pieces.map(piece => piece[2]))];
    const line = (label, ink, values) => ({label, ink, width: 2.2, values, more: {}});
    if (names.length < 2) return [line(say('measured {0}', output), this.inks[0], measured)];
    return names.map((name, i) => {
      const own = pieces.filter(piece => piece[2] === name);
      return line(`${say('measured {0}', output)}, ${name}`, this.inks[i], measured.map((value, k) =>
        own.some(([from, to]) => t[k] >= from && t[k] <= to) ? value : null));
    });
  }

  // Outputs of other models, drawn over the present one: [{label, ink, values}]. `whose`
  // tells lines for one purpose from those for another.
  others(whose, lines) {
    if (!lines.length && !this.over[whose]?.length) return;
    this.over[whose] = lines;
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
      residual[0].values = simulated ? this.without(simulated.map((s, k) => d.measured[k] - s)) : d.residual;
    }
    this.refresh();
  }

  draw() {
    for (const {plot} of this.plots) plot.destroy();
    this.plots = [];
    if (!this.data) return;
    this.shading.of(this.data);
    this.overview.values = null;  // its colours may be others
    const d = this.data, y = d.output;
    const line = (label, ink, width, values, more = {}) => ({label, ink, width, values, more});
    const output = this.measured();
    if (d.sp) output.push(line(say('setpoint'), 'setpoint', 1.4, d.sp, {dash: [6, 4]}));
    this.index = {output, simulated: output.length};
    // 95 % of the residual lies in the band.
    const around = d.residual ? spread(d.residual) : 0;
    if (d.simulated) output.push(line(say('simulated {0}', y), 'valve', 1.5, d.simulated, {around}));
    for (const {label, ink, values} of Object.values(this.over).flat()) output.push(line(label, ink, 1.3, values));
    this.add('output', withUnit(y, this.units[y]), output);
    if (d.residual) {
      this.index.residual = [line(say('residual'), 'linear', 1.2, d.residual)];
      this.add('residual', say('residual'), this.index.residual);
    }
    this.add('u', withUnit('u', this.units.u), [line(say('controller output u'), 'two-path', 1.3, d.u)], this.label);
    this.refresh();
  }

  text(value, digits = 5) {
    return value == null ? '–' : number(value, digits);
  }

  add(name, axis, lines, timeLabel = null) {
    const text = colour('soft'), grid = {stroke: colour('grid'), width: 1};
    const font = '12px system-ui, sans-serif';
    const clock = this.clock !== null;
    const series = lines.map(({label, ink, width, more}) => ({label, stroke: colour(ink), width,
      points: {show: false}, paths: () => null, value: (_, v) => this.text(v), ...more}));
    const times = (u, splits, _, __, by) => splits.map((v, i) => !clock ? this.text(v, 6)
      : by >= 86400 || i === 0 && by >= 60 || v % 86400 === 0 ? dayText(v) + (by >= 86400 ? '' : ' ' + clockText(v, false))
        : clockText(v, by < 60));
    const plot = new uPlot({
      width: Math.max(this.box.clientWidth, 200),
      height: HEIGHTS[name] + (timeLabel ? 44 : 0),
      cursor: {sync: {key: 'stickband'}, y: false, drag: {x: true, y: false, setScale: false},
               points: {size: 6}, bind: {dblclick: () => () => { this.zoom('all'); }}},
      legend: {live: true},
      scales: {x: {time: clock, range: () => this.visible()},
               y: {range: (_, least, most) => this.reach(name, least, most)}},
      tzDate: seconds => uPlot.tzDate(new Date(seconds * 1000), 'Etc/UTC'),
      series: [{label: clock ? say('time') : this.label.replace(/^[^,]*/, 't').replace(/(,[^,]*),.*/, '$1'),
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
        drawClear: [self => this.shading.behind(self, name)],
        drawAxes: [self => this.envelopes(self, name)],
        drawSeries: [drawLine],
      },
    }, [[0, 1], ...series.map(() => [null, null])], this.box);
    this.plots.push({plot, lines, axis, name});
  }

  // How far the values of a plot reach, with what its lines hide; the band around them is
  // cut off, or the lines would be flat beside it.
  reach(name, least, most) {
    const seen = this.plots.find(item => item.name === name)?.seen;
    if (!seen) return [least ?? 0, most ?? 1];
    const [low, high] = extent(seen.flatMap(({lows, highs}) => [lows, highs]));
    const room = 0.05 * (high - low) || 1;
    // The strip below the residual has a place of its own.
    const below = name === 'residual' ? 3 * room : room;
    return [low - below, high + room];
  }

  // Behind each line what it is the mean of, and the band that its residual lies in.
  envelopes(plot, name) {
    const item = this.plots.find(one => one.name === name);
    if (!item?.seen) return;
    const {ctx, bbox} = plot, t = plot.data[0];
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    item.seen.forEach(({bottom, top, thick}, i) => {
      if (!thick) return;
      const x = value => Math.round(plot.valToPos(value, 'x', true));
      const y = value => Math.round(plot.valToPos(value, 'y', true));
      ctx.globalAlpha = item.lines[i].more.around ? 0.18 : 0.3;
      ctx.fillStyle = plot.series[i + 1].stroke();
      for (let first = 0, last; first < t.length; first = last + 1) {
        for (last = first; last < t.length && top[last] !== null; ++last);
        ctx.beginPath();
        for (let k = first; k < last; ++k) ctx.lineTo(x(t[k]), y(top[k]));
        for (let k = last; k-- > first;) ctx.lineTo(x(t[k]), y(bottom[k]));
        ctx.fill();
      }
    });
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
    for (const item of this.plots) {
      const {plot, lines} = item;
      const pixels = Math.max(Math.round(plot.bbox.width / devicePixelRatio), 100);
      const {t, dense, signals} = envelope(this.t, lines.map(line => line.values), part, pixels);
      item.seen = signals.map(({mean, low, high}, i) => {
        const around = lines[i].more.around ?? 0;
        const by = (values, value) => value ? values.map(v => v === null ? null : v + value) : values;
        const lows = dense ? low : mean, highs = dense ? high : mean;
        return {lows, highs, bottom: by(lows, -around), top: by(highs, around), thick: dense || around > 0};
      });
      plot.setData([t, ...signals.map(({mean}) => mean)], true);
    }
    this.overview.draw(this.t, this.data.measured, range, this.shading.apart());
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
