// Other recordings of the same loop, each in its own colour: judged by every model, never
// fitted. Only the initial state is estimated.
import {get, post, withQuery} from './api.js';
import {$, element, number} from './dom.js';
import {say, translated} from './texts.js';
import {unitFor} from './times.js';
import {picture} from './xy.js';

export const BESIDE_INKS = ['two-path', 'truth', 'setpoint', 'linear', 'bad', 'good'];

export class Beside {
  // act(work, heading) runs what changes them.
  constructor(charts, act) {
    this.act = act;
    this.shown = '';
  }

  async show(state) {
    const key = `${state.drawn} ${state.beside.join()}`;
    if (key === this.shown) return;
    this.shown = key;
    const {recordings} = state.beside.length ? await get('/api/beside') : {recordings: []};
    $('beside').replaceChildren(
      element('h2', {textContent: say('Other recordings of this loop')}),
      element('p', {textContent: say('Each is judged by the model and has no part in its fit; only where it starts is estimated. Units must be the same.')}),
      ...recordings.length ? [this.table(state, recordings), element('div', {className: 'pictures'},
        ...recordings.flatMap((recording, i) => this.picture(state, recording, i)))] : [],
      this.chooser());
    $('beside').hidden = false;
  }

  chooser() {
    const input = element('input', {type: 'file', accept: '.csv,.txt,.tsv', className: 'away', id: 'beside-file'});
    input.onchange = () => {
      const file = input.files[0];
      if (file) this.act(() => post(withQuery('/api/beside', {name: file.name}), file),
        say('{0} cannot be used.', file.name));
    };
    return element('p', {}, input, element('label', {className: 'button', htmlFor: 'beside-file',
      textContent: say('Judge another recording…')}));
  }

  table(state, recordings) {
    const body = element('tbody', {}, this.row(state.recording.name, 'measured',
      state.model.fit_percent, state.model.rmse, say('open above')));
    recordings.forEach((recording, i) => {
      const close = element('button', {type: 'button', className: 'small', textContent: say('Close')});
      close.setAttribute('aria-label', say('Close {0}', recording.name));
      close.onclick = () => this.act(() => post('/api/dismiss', {which: i}));
      body.append(this.row(recording.name, BESIDE_INKS[i], recording.fit_percent, recording.rmse,
        recording.error ? translated(recording.error.message) : close));
    });
    return element('div', {className: 'scroll'}, element('table', {}, element('thead', {},
      element('tr', {}, ...[say('Recording'), say('Fit, %'), say('Error'), ''].map(textContent =>
        element('th', {textContent})))), body));
  }

  row(name, ink, fit, rmse, last) {
    return element('tr', {}, element('td', {}, element('i', {className: `dot ${ink}`}), ` ${name}`),
      element('td', {textContent: number(fit, 4)}), element('td', {textContent: number(rmse, 4)}),
      element('td', {}, last));
  }

  picture(state, {name, picture: p, units}, i) {
    if (!p) return [];
    const [size, unit] = unitFor(p.t.at(-1)), x = p.t.map(t => t / size), y = state.model.output;
    const lines = [{label: say('measured {0}', y), ink: BESIDE_INKS[i], x, y: p.measured}];
    if (p.simulated.length) lines.push({label: say('simulated {0}', y), ink: 'valve', x, y: p.simulated});
    return [picture({title: name, xLabel: say('time, {0}', unit),
      yLabel: units[y] ? `${y}, ${units[y]}` : y, lines, width: 440})];
  }
}
