// The whole recording in a strip, with what the charts show of it; drag to move along.
import {colour} from './dom.js';
import {envelope, extent} from './envelope.js';

const HEIGHT = 46, LEFT = 52;

export class Overview {
  // look(min, max) shows a range of t in the charts.
  constructor(canvas, look) {
    Object.assign(this, {canvas, look});
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      this.drag(event);
    });
    canvas.addEventListener('pointermove', event => {
      if (canvas.hasPointerCapture(event.pointerId)) this.drag(event);
    });
  }

  drag(event) {
    if (!this.t) return;
    const [min, max] = this.range, first = this.t[0], last = this.t.at(-1);
    if (max - min >= last - first) return;
    const share = (event.offsetX - LEFT) / (this.canvas.clientWidth - LEFT);
    const middle = first + share * (last - first), half = (max - min) / 2;
    this.look(middle - half, middle + half);
  }

  // `apart`: ranges of t that are left out.
  draw(t, values, range, apart) {
    const wide = this.canvas.clientWidth, ratio = devicePixelRatio;
    const same = this.values === values && this.wide === wide && this.ratio === ratio &&
      this.apart?.length === apart.length;
    Object.assign(this, {t, values, range, apart, wide, ratio});
    if (!wide) return;
    const [first, last] = [t[0], t.at(-1)];
    this.canvas.classList.toggle('still', range[1] - range[0] >= last - first);
    if (!same) this.paint();
    const ctx = this.canvas.getContext('2d'), x = at => this.x(at);
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.clearRect(0, 0, this.canvas.width, this.canvas.height);
    ctx.drawImage(this.strip, 0, 0);
    ctx.scale(ratio, ratio);
    ctx.globalAlpha = 0.2;
    ctx.fillStyle = this.ink;
    const from = x(Math.max(range[0], first)), to = x(Math.min(range[1], last));
    ctx.fillRect(from, 0, Math.max(to - from, 2), HEIGHT);
    ctx.globalAlpha = 1;
    ctx.strokeStyle = this.ink;
    ctx.strokeRect(from + 0.5, 0.5, Math.max(to - from - 1, 2), HEIGHT - 1);
  }

  x(at) {
    const [first, last] = [this.t[0], this.t.at(-1)];
    return LEFT + (this.wide - LEFT) * (at - first) / (last - first);
  }

  // The signal, once for all ranges.
  paint() {
    const {t, values, wide, ratio} = this;
    this.ink = colour('two-path');
    this.canvas.width = wide * ratio;
    this.canvas.height = HEIGHT * ratio;
    this.strip = document.createElement('canvas');
    this.strip.width = this.canvas.width;
    this.strip.height = this.canvas.height;
    const ctx = this.strip.getContext('2d');
    ctx.scale(ratio, ratio);
    ctx.globalAlpha = 0.3;
    ctx.fillStyle = colour('soft');
    for (const [from, to] of this.apart) ctx.fillRect(this.x(from), 0, this.x(to) - this.x(from), HEIGHT);
    ctx.globalAlpha = 1;
    const seen = envelope(t, [values], [0, t.length], wide - LEFT);
    const {mean, low, high} = seen.signals[0];
    const least = seen.dense ? low : mean, most = seen.dense ? high : mean;
    const [bottom, top] = extent([least, most]);
    const y = value => HEIGHT - 3 - (HEIGHT - 6) * (value - bottom) / (top - bottom || 1);
    ctx.strokeStyle = colour('measured');
    ctx.beginPath();
    seen.t.forEach((at, i) => {
      if (i === 0) ctx.moveTo(this.x(at), y(most[i])); else ctx.lineTo(this.x(at), y(most[i]));
      if (seen.dense) ctx.lineTo(this.x(at), y(least[i]));
    });
    ctx.stroke();
  }
}
