// The residual sample by sample, over what may cause it.
import {$, element, withUnit} from './dom.js';
import {extent} from './envelope.js';
import {say} from './texts.js';
import {picture} from './xy.js';

const MOST = 3000;  // points drawn

// 0 at a lower reversal of u, 1 at the next; reversals are told by a tenth of the span.
function phase(u) {
  const [low, high] = extent([u]), room = (high - low) / 10, turns = [];
  let rising = false, best = 0;
  u.forEach((value, k) => {
    if (rising ? value > u[best] : value < u[best]) best = k;
    if (rising ? value < u[best] - room : value > u[best] + room) {
      if (!rising) turns.push(best);
      rising = !rising;
      best = k;
    }
  });
  const out = new Array(u.length).fill(null);
  for (let i = 1; i < turns.length; ++i) {
    for (let k = turns[i - 1]; k < turns[i]; ++k) {
      out[k] = (k - turns[i - 1]) / (turns[i] - turns[i - 1]);
    }
  }
  return out;
}

// Of every sample the coordinate that is asked for.
const COORDINATES = {
  u: d => d.u,
  speed: d => d.u.map((v, k) => k ? (v - d.u[k - 1]) / (d.t[k] - d.t[k - 1]) : 0),
  phase: d => phase(d.u),
  simulated: d => d.simulated,
};

export function showScatter(data, units) {
  const box = $('scatter');
  box.hidden = !data.residual;
  if (!data.residual) return;
  const names = {
    u: withUnit(say('controller output u'), units.u),
    speed: say('speed of u, {0}', units.u ? `${units.u}/s` : 'u/s'),
    phase: say('phase of the cycle of u'),
    simulated: withUnit(say('simulated {0}', data.output), units[data.output]),
  };
  const draw = () => {
    const every = Math.ceil(data.t.length / MOST);
    box.querySelector('.pictures').replaceChildren(...Object.entries(COORDINATES).flatMap(([name, of]) => {
      const all = of(data), x = [], y = [];
      for (let k = 0; k < all.length; k += every) {
        if (all[k] === null || data.residual[k] === null) continue;
        x.push(all[k]);
        y.push(data.residual[k]);
      }
      if (!x.length) return [];
      return picture({title: say('Residual over {0}', names[name].replace(/,.*/, '')),
        xLabel: names[name], yLabel: withUnit(say('residual'), units[data.output]),
        lines: [{ink: 'linear', dots: true, x, y}]});
    }));
  };
  const details = element('details', {open: box.querySelector('details')?.open ?? false},
    element('summary', {textContent: say('The residual sample by sample')}),
    element('div', {className: 'pictures'}));
  details.ontoggle = () => { if (details.open) draw(); };
  box.replaceChildren(details);
  if (details.open) draw();
}
