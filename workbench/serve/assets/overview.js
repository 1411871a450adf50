// The whole recording in a strip, with what the charts show of it; drag to move along.
import {colour} from './dom.js';
import {envelope} from './envelope.js';

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

  draw(t, values, range) {
    Object.assign(this, {t, values, range});
    const ratio = devicePixelRatio, width = this.canvas.clientWidth;
    if (!width) return;
    const [first, last] = [t[0], t.at(-1)];
    const whole = range[1] - range[0] >= last - first;
    this.canvas.classList.toggle('still', whole);
    this.canvas.width = width * ratio;
    this.canvas.height = HEIGHT * ratio;
    const ctx = this.canvas.getContext('2d');
    ctx.scale(ratio, ratio);
    if (this.of !== values || this.wide !== width) {
      this.seen = envelope(t, [values], [0, t.length], width - LEFT);
      Object.assign(this, {of: values, wide: width});
    }
    const {mean, low, high} = this.seen.signals[0];
    const least = this.seen.dense ? low : mean, most = this.seen.dense ? high : mean;
    const bottom = Math.min(...least), top = Math.max(...most);
    const x = at => LEFT + (width - LEFT) * (at - first) / (last - first);
    const y = value => HEIGHT - 3 - (HEIGHT - 6) * (value - bottom) / (top - bottom || 1);
    ctx.strokeStyle = colour('measured');
    ctx.beginPath();
    this.seen.t.forEach((at, i) => {
      if (i === 0) ctx.moveTo(x(at), y(most[i])); else ctx.lineTo(x(at), y(most[i]));
      if (this.seen.dense) ctx.lineTo(x(at), y(least[i]));
    });
    ctx.stroke();
    ctx.globalAlpha = 0.2;
    ctx.fillStyle = colour('two-path');
    const from = x(Math.max(range[0], first)), to = x(Math.min(range[1], last));
    ctx.fillRect(from, 0, Math.max(to - from, 2), HEIGHT);
    ctx.globalAlpha = 1;
    ctx.strokeStyle = colour('two-path');
    ctx.strokeRect(from + 0.5, 0.5, Math.max(to - from - 1, 2), HEIGHT - 1);
  }
}
