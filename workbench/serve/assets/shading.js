// What lies behind the lines of the charts: stretches to beware of, what is left out, and
// which samples were fitted.
import {colour} from './dom.js';

// Where each kind of mark (serve/marks.hpp) is drawn.
const PLOT_OF = {limit: 'u', rest: 'u', step: 'u', held: 'output', straight: 'output', gap: '', manual: ''};

export class Shading {
  // position(seconds) is where a time stands on the axis of the plots.
  constructor(position) {
    this.position = position;
  }

  // Asks for the colours once: that is slow.
  of(data) {
    this.data = data;
    this.inks = {mark: colour('open'), fitted: colour('usual'), judging: colour('two-path'),
                 out: colour('soft'), card: colour('card')};
  }

  // Stretches that are left out, on the axis of the plots.
  apart() {
    return this.data.left_out.map(range => range.map(this.position));
  }

  behind(plot, name) {
    const {ctx, bbox} = plot, {data: d, inks} = this;
    const right = bbox.left + bbox.width;
    const at = seconds => plot.valToPos(this.position(seconds), 'x', true);
    const box = (from, to, top, height, ink, alpha = 1, least = 0) => {
      const first = Math.max(at(from), bbox.left), last = Math.min(at(to), right);
      if (last < bbox.left || first > right) return;
      ctx.globalAlpha = alpha;
      ctx.fillStyle = ink;
      ctx.fillRect(first, top, Math.max(last - first, least), height);
    };
    ctx.save();
    for (const [from, to, kind] of d.marks) {
      const where = PLOT_OF[kind];
      if (where && where !== name) continue;
      const narrow = kind === 'step';
      box(from, narrow ? from : to, bbox.top, bbox.height, inks.mark, narrow ? 0.55 : 0.22,
        narrow ? devicePixelRatio : 0);
    }
    for (const [from, to] of d.left_out) {
      box(from, to, bbox.top, bbox.height, inks.out, 0.3);
    }
    // Where the next recording begins, or the same goes on after a pause.
    for (const [from] of d.pieces.slice(1)) {
      box(from, from, bbox.top, bbox.height, inks.out, 0.7, devicePixelRatio);
    }
    if (name === 'residual') {
      const thick = 6 * devicePixelRatio;
      for (const [from, to, fitted] of d.blocks) {
        box(from, to, bbox.top + bbox.height - thick, thick, fitted ? inks.fitted : inks.judging);
      }
    }
    ctx.restore();
  }
}
