// The models so far side by side, and over one another in the charts.
import {complain} from './alert.js';
import {ApiError, get} from './api.js';
import {parameterWords} from './direction.js';
import {$, capital, element, number, withUnitOf} from './dom.js';
import {say, translated} from './texts.js';

const INKS = ['two-path', 'truth', 'setpoint', 'linear'];

export class Models {
  constructor(charts, title) {
    Object.assign(this, {charts, title});
    this.drawn = -1;
  }

  async show(state) {
    if (!state.model) return;
    if (this.drawn === state.drawn) return;
    this.drawn = state.drawn;
    this.charts.others('models', []);
    const {models} = await get('/api/models');
    $('compare').hidden = models.length < 2;
    if (models.length < 2) return $('compare').replaceChildren();
    const names = models.map((model, i) => this.nameOf(model, models[i - 1]));
    const rows = new Map();  // "effect: parameter" → a cell for each model
    models.forEach((model, i) => {
      for (const [group, parameters] of [['process', model.process],
        ...model.effects.map(term => [term.effect, term.parameters])]) {
        for (const p of Object.values(parameters).filter(({idle}) => !idle)) {
          const key = `${capital(this.title(group))}: ${parameterWords(p.words)}` +
            (p.unit_in_words && `, ${p.unit_in_words}`);
          if (!rows.has(key)) rows.set(key, models.map(() => '–'));
          rows.get(key)[i] = p.choice ? translated(p.choice) : number(p.value, 4);
        }
      }
    });
    const table = element('table', {}, element('thead', {}, element('tr', {}, element('th'),
      ...names.map((name, i) => element('th', {}, this.box(name, i, models.length))))));
    const body = element('tbody');
    const line = (label, cells) => body.append(element('tr', {}, element('td', {textContent: label}),
      ...cells.map(textContent => element('td', {textContent}))));
    line(say('Fit, %'), models.map(m => number(m.fit_percent, 4)));
    const {units} = state.recording, {output} = state.model;
    line(withUnitOf(say('Error'), output, units), models.map(m => number(m.rmse, 4)));
    line(withUnitOf(say('Validation error'), output, units), models.map(m => number(m.rmse_validation, 4)));
    for (const [key, cells] of rows) line(key, cells);
    table.append(body);
    $('compare').replaceChildren(element('h2', {textContent: say('Models side by side')}),
      element('p', {textContent: say('Tick an earlier model to draw it over the present one.')}),
      element('div', {className: 'scroll', tabIndex: 0, role: 'region',
        ariaLabel: say('Models side by side')}, table));
  }

  nameOf(model, before) {
    const codes = model.effects.map(term => this.title(term.effect));
    const name = codes.length ? codes.join(' + ') : say('textbook model');
    const last = model.history.at(-1);
    if (last?.effect === 'refit') return say('{0}, fitted to {1}', name, last.recording);
    const same = before && before.effects.map(term => term.effect).join() ===
      model.effects.map(term => term.effect).join();
    if (last?.effect === 'by hand') return say('{0}, values set by hand', name);
    return same ? say('{0}, other values', name) : name;
  }

  box(name, i, count) {
    if (i + 1 === count) return `${i + 1}. ${name}`;
    const input = element('input', {type: 'checkbox'});
    input.dataset.model = i;
    input.onchange = () => this.redraw();
    return element('label', {}, input, ` ${i + 1}. ${name}`);
  }

  async redraw() {
    const chosen = [...$('compare').querySelectorAll('input:checked')];
    const asked = this.asked = (this.asked ?? 0) + 1;
    try {
      const lines = await Promise.all(chosen.map(async (input, k) => {
        const {simulated} = await get(`/api/simulated?model=${input.dataset.model}`);
        return {label: input.parentElement.textContent.trim(), ink: INKS[k % INKS.length], values: simulated};
      }));
      if (asked === this.asked) this.charts.others('models', lines);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      complain(error);
    }
  }
}
