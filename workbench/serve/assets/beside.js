// Other recordings of the same loop, each in its own colour: judged by every model, or
// fitted together with the one that is open. Of one that judges only the initial state is
// estimated.
import {get, post} from './api.js';
import {$, button, element, number, select, withUnit, withUnitOf} from './dom.js';
import {say, translated} from './texts.js';
import {unitFor} from './times.js';
import {picture} from './xy.js';

const OWN_INK = 'measured', BESIDE_INKS = ['two-path', 'truth', 'setpoint', 'linear', 'bad', 'good'];

// Of the recordings that are fitted, in their order.
export const inksOf = state =>
  [OWN_INK, ...BESIDE_INKS.filter((_, i) => state.beside_fitted[i])];

export class Beside {
  // act(work, heading) runs what changes them, together(work) what fits anew, open(file)
  // opens one more.
  constructor(act, together, open) {
    Object.assign(this, {act, together, open});
    this.shown = '';
  }

  async show(state) {
    const key = `${state.drawn} ${state.beside.join()} ${state.beside_fitted.join()}`;
    if (key === this.shown) return;
    this.shown = key;
    const {own, recordings} = state.beside.length ? await get('/api/beside') : {recordings: []};
    const focus = $('beside').contains(document.activeElement) && document.activeElement.id;
    $('beside').replaceChildren(
      element('h2', {textContent: say('Other recordings of this loop')}),
      element('p', {textContent: say('Each is judged by the model and has no part in its fit, only where it starts is estimated; or the model is fitted to it, too: one valve, one process, a start each. Units must be the same.')}),
      ...recordings.length ? [this.table(state, own, recordings), element('div', {className: 'pictures'},
        ...recordings.flatMap((recording, i) => this.picture(state, recording, i)))] : [],
      this.chooser());
    $('beside').hidden = false;
    if (focus) document.getElementById(focus)?.focus();
  }

  chooser() {
    const input = element('input', {type: 'file', accept: '.csv,.txt,.tsv,.xlsx,.ods,.dat,.lvm', className: 'away', id: 'beside-file'});
    input.onchange = () => {
      const file = input.files[0];
      input.value = '';
      if (file) this.open(file);
    };
    return element('p', {}, input, element('label', {className: 'button', htmlFor: 'beside-file',
      textContent: say('Judge another recording…')}));
  }

  table(state, own, recordings) {
    const together = state.beside_fitted.includes(true);
    const body = element('tbody', {}, this.row(state.beside_own, OWN_INK, own,
      say('fitted'), say('open above')));
    recordings.forEach((recording, i) => {
      const close = button(say('Close'),
        () => (recording.fitted ? this.together : this.act)(() => post('/api/dismiss', {which: i})),
        {className: 'small', ariaLabel: say('Close {0}', recording.name)});
      const said = recording.error ? translated(recording.error.message)
        : recording.fit_percent < 0 ? say('The model says less about it than the mean of its output does: is it another loop?') : '';
      body.append(this.row(recording.name, BESIDE_INKS[i], recording, this.part(recording, i),
        ...said ? [said, ' ', close] : [close]));
    });
    if (together) {
      body.append(this.row(say('All that are fitted'), null, state.model, '', ''));
    }
    return element('div', {className: 'scroll', tabIndex: 0, role: 'region',
      ariaLabel: say('Other recordings of this loop')}, element('table', {}, element('thead', {},
      element('tr', {}, ...[say('Recording'), say('Part'), say('Fit, %'), ...['Error', 'Validation error'].map(text =>
        withUnitOf(translated(text), state.model.output, state.recording.units)), '']
        .map(textContent => element('th', {textContent, className: textContent === say('Part') ? 'text' : ''})))), body));
  }

  // Whether it is fitted or only judges.
  part(recording, i) {
    const chosen = recording.fitted ? 'fit' : '';
    const choice = select([['', say('only judges')], ['fit', say('is fitted, too')]], chosen, async part => {
      await this.together(() => post('/api/together', {which: i, fit: part === 'fit'}));
      // What was refused is not so.
      if (choice.isConnected && !document.getElementById('alert').hidden) choice.value = chosen;
    }, {id: `part-${i}`, ariaLabel: say('The part of {0}', recording.name)});
    return choice;
  }

  row(name, ink, errors, part, ...last) {
    const cells = [errors?.fit_percent, errors?.rmse, errors?.rmse_validation];
    return element('tr', {}, element('td', {}, ...ink ? [element('i', {className: `dot ${ink}`}), ' '] : [], name),
      element('td', {className: 'text'}, part),
      ...cells.map(value => element('td', {textContent: number(value, 4)})), element('td', {}, ...last));
  }

  picture(state, {name, picture: p, units}, i) {
    if (!p) return [];
    const [size, unit] = unitFor(p.t.at(-1)), x = p.t.map(t => t / size), y = state.model.output;
    const lines = [{label: say('measured {0}', y), ink: BESIDE_INKS[i], x, y: p.measured}];
    if (p.simulated.length) lines.push({label: say('simulated {0}', y), ink: 'valve', x, y: p.simulated});
    return [picture({title: name, xLabel: say('time, {0}', unit),
      yLabel: withUnit(y, units[y]), lines, width: 440})];
  }
}
