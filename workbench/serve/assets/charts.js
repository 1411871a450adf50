// Measured and simulated output, residual and u over one time axis, zoomed together.

const HEIGHTS = {output: 240, residual: 110, u: 120};

const unitFor = span =>
  span < 600 ? [1, 'time, s'] : span < 6 * 3600 ? [60, 'time, min']
    : span < 4 * 86400 ? [3600, 'time, h'] : [86400, 'time, days'];

const colour = name =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const short = value => value == null ? '–' : String(Number(value.toPrecision(5)));

export class Charts {
  constructor(box) {
    this.box = box;
    this.plots = [];
    this.data = null;
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
  show(data) {
    const same = this.data && this.data.t.length === data.t.length &&
      this.data.t[0] === data.t[0] && this.data.t.at(-1) === data.t.at(-1);
    if (!same) this.range = null;
    this.data = data;
    const [seconds, label] = unitFor(data.t.at(-1) - data.t[0]);
    this.seconds = seconds;
    this.label = label;
    this.t = data.t.map(t => t / seconds);
    this.draw();
  }

  draw() {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    if (!this.data) return;
    const d = this.data, y = d.output;
    const line = (label, ink, width = 1.5, more = {}) =>
      ({label, stroke: colour(ink), width, points: {show: false},
        value: (_, v) => short(v), ...more});
    const output = [line(`measured ${y}`, 'measured', 2.2)], values = [d.measured];
    if (d.sp) {
      output.push(line('setpoint', 'setpoint', 1, {dash: [6, 4]}));
      values.push(d.sp);
    }
    if (d.simulated) {
      output.push(line(`simulated ${y}`, 'valve', 1.5));
      values.push(d.simulated);
    }
    this.add('output', y, output, values);
    if (d.residual) {
      this.add('residual', 'residual', [line('residual', 'linear', 1.2)], [d.residual]);
    }
    this.add('u', 'u', [line('controller output u', 'two-path', 1.3)], [d.u], this.label);
  }

  add(name, axis, series, values, timeLabel = null) {
    const text = colour('soft'), grid = {stroke: colour('grid'), width: 1};
    const font = '12px system-ui, sans-serif';
    const plot = new uPlot({
      width: this.box.clientWidth,
      height: HEIGHTS[name] + (timeLabel ? 44 : 0),
      cursor: {sync: {key: 'stickband'}, y: false, drag: {x: true, y: false},
               points: {size: 6}},
      legend: {live: true},
      scales: {x: {time: false}},
      series: [{label: this.label.replace('time, ', 't, '), value: (_, v) => short(v)},
               ...series],
      axes: [
        {stroke: text, grid, ticks: grid, font, labelFont: font,
         label: timeLabel ?? undefined, labelSize: 20, size: timeLabel ? 28 : 8,
         ...(timeLabel ? {} : {values: () => []})},
        {stroke: text, grid, ticks: grid, font, labelFont: font, label: axis,
         labelSize: 18, size: 52, space: 22,
         values: (_, splits) => splits.map(v => String(Number(v.toPrecision(6))))},
      ],
      hooks: {setScale: [(self, key) => { if (key === 'x') this.follow(self); }]},
    }, [this.t, ...values], this.box);
    this.plots.push(plot);
    if (this.range) plot.setScale('x', this.range);
  }

  // One plot was zoomed: the others follow.
  follow(plot) {
    if (this.following) return;
    const {min, max} = plot.scales.x;
    if (min == null) return;
    const whole = min <= this.t[0] && max >= this.t.at(-1);
    this.range = whole ? null : {min, max};
    this.following = true;
    for (const other of this.plots) if (other !== plot) other.setScale('x', {min, max});
    this.following = false;
  }

  set(min, max) {
    const first = this.t[0], last = this.t.at(-1);
    const width = Math.min(Math.max(max - min, (last - first) / 2000), last - first);
    const start = Math.min(Math.max((min + max - width) / 2, first), last - width);
    if (this.plots.length) this.plots[0].setScale('x', {min: start, max: start + width});
  }

  // Seconds, as in the answers of the API, with some room around.
  lookAt(from, to) {
    const room = Math.max((to - from) * 0.6, 0);
    this.set((from - room) / this.seconds, (to + room) / this.seconds);
  }

  zoom(what) {
    if (!this.plots.length) return;
    const {min, max} = this.plots[0].scales.x, width = max - min;
    if (what === 'all') this.set(this.t[0], this.t.at(-1));
    if (what === 'in') this.set(min + width / 4, max - width / 4);
    if (what === 'out') this.set(min - width / 2, max + width / 2);
    if (what === 'left') this.set(min - width / 4, max - width / 4);
    if (what === 'right') this.set(min + width / 4, max + width / 4);
  }

  fit() {
    for (const plot of this.plots) {
      if (plot.width !== this.box.clientWidth) {
        plot.setSize({width: this.box.clientWidth, height: plot.height});
      }
    }
  }
}
