// The residual sample by sample, over what may cause it.
import {$, element} from './dom.js';
import {say} from './texts.js';
import {picture} from './xy.js';

const MOST = 3000;  // points drawn

// Of every sample the coordinate that is asked for.
const COORDINATES = {
  u: d => d.u,
  speed: d => d.u.map((v, k) => k ? (v - d.u[k - 1]) / (d.t[k] - d.t[k - 1]) : 0),
  simulated: d => d.simulated,
};

export function showScatter(data, units) {
  const box = $('scatter');
  box.hidden = !data.residual;
  if (!data.residual) return;
  const withUnit = (text, unit) => unit ? `${text}, ${unit}` : text;
  const names = {
    u: withUnit(say('controller output u'), units.u),
    speed: say('speed of u, {0}', units.u ? `${units.u}/s` : 'u/s'),
    simulated: withUnit(say('simulated {0}', data.output), units[data.output]),
  };
  const draw = () => {
    const every = Math.ceil(data.t.length / MOST);
    box.querySelector('.pictures').replaceChildren(...Object.entries(COORDINATES).map(([name, of]) => {
      const all = of(data), x = [], y = [];
      for (let k = 0; k < all.length; k += every) {
        x.push(all[k]);
        y.push(data.residual[k]);
      }
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
