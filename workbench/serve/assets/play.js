// Playing with the model: a slider for each parameter; error and curves follow at once.
import {ApiError, get, post} from './api.js';
import {complain} from './alert.js';
import {parameterWords} from './direction.js';
import {$, button, capital, element, noNumber, number, readNumber, select, written} from './dom.js';
import {say, translated} from './texts.js';

const STEPS = 1000;

// Where the slider stands for a value: within the physical bounds, even in the logarithm
// where they span decades.
function scaleOf({value, bounds}) {
  let [low, high] = bounds;
  const reach = Math.max(Math.abs(value), 1e-6);
  if (low == null || low < value - 4 * reach) low = value - 4 * reach;
  if (high == null || high > value + 4 * reach) high = value + 4 * reach;
  low = Math.min(low, value);
  high = Math.max(high, value);
  const log = low > 0 && high / low > 100;
  return {
    at: v => STEPS * (log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low || 1)),
    of: s => log ? low * (high / low) ** (s / STEPS) : low + (high - low) * s / STEPS,
  };
}

const MOST = 1e100;
const ROUNDING = 1e-4;  // of a bound: the fields show five digits

// Why `value`, read from `text`, is not taken; empty where it is.
function problem(label, text, value, [low, high]) {
  if (value === null) return noNumber(label, text);
  low ??= -MOST;
  high ??= MOST;
  if (value >= low - ROUNDING * Math.abs(low) && value <= high + ROUNDING * Math.abs(high)) return '';
  return say('{0}: expected {1} to {2}, found {3}.', label, number(low, 6), number(high, 6), number(value, 6));
}

export class Play {
  // refit(work) runs a fit from the values on the page.
  constructor(charts, change, title, refit) {
    Object.assign(this, {charts, change, title, refit});
    this.drawn = -1;
    this.held = new Set();  // "group name" of what a fit leaves as it is
  }

  async show(state) {
    if (!state.model || state.recording.samples > 100000) {
      $('play').replaceChildren();
      $('play').hidden = true;
      return;
    }
    if (this.drawn === state.drawn) return;
    this.drawn = state.drawn;
    const {models} = await get('/api/models');
    this.model = models.at(-1);
    this.values = {};
    this.waiting = null;
    this.draw();
    $('play').hidden = false;
  }

  // A number that stands for a choice: its words.
  choice(group, name, parameter, put, fixed) {
    const words = capital(parameterWords(parameter.words));
    const box = select(parameter.choices.map(([value, text]) => [value, translated(text)]),
      parameter.choices.find(([, text]) => text === parameter.choice)?.[0],
      value => put(Number(value)), {ariaLabel: `${this.title(group)}: ${words}`});
    return element('li', {className: 'chosen'}, element('span', {textContent: words}), box,
      element('label', {className: 'fine'}, fixed, ' ' + say('fixed')));
  }

  row(group, name, parameter) {
    const scale = scaleOf(parameter), words = parameterWords(parameter.words);
    const label = `${this.title(group)}: ${words}`;
    const slider = element('input', {type: 'range', min: 0, max: STEPS, step: 1,
      value: Math.round(scale.at(parameter.value))});
    const field = element('input', {type: 'text', inputMode: 'decimal', size: 9, autocomplete: 'off',
      value: written(parameter.value)});
    slider.setAttribute('aria-label', label);
    field.setAttribute('aria-label', say('{0}, as a number', label));
    const put = value => {
      this.refuse(field, '');
      (this.values[group] ??= {})[name] = value;
      this.ask();
    };
    slider.oninput = () => {
      const value = Number(scale.of(Number(slider.value)).toPrecision(6));
      field.value = written(value, 6);
      put(value);
    };
    field.onchange = () => {
      const value = readNumber(field.value), why = problem(label, field.value, value, parameter.bounds);
      if (why) return this.refuse(field, why);
      field.value = written(value, 6);
      slider.value = Math.round(scale.at(value));
      put(value);
    };
    const key = `${group} ${name}`;
    const fixed = element('input', {type: 'checkbox', checked: this.held.has(key)});
    fixed.setAttribute('aria-label', say('{0}, fixed', label));
    fixed.onchange = () => {
      if (fixed.checked) this.held.add(key); else this.held.delete(key);
    };
    if (parameter.choices) return this.choice(group, name, parameter, put, fixed);
    return element('li', {}, element('span', {textContent: capital(words)}),
      slider, field, element('span', {className: 'fine', textContent: parameter.unit_in_words}),
      element('label', {className: 'fine'}, fixed, ' ' + say('fixed')));
  }

  // Marks what is not taken, and says why; the model keeps the value it had.
  refuse(field, why) {
    if (why) this.refused.set(field, why); else this.refused.delete(field);
    field.ariaInvalid = why ? 'true' : null;
    this.problems.replaceChildren(...[...this.refused.values()].map(textContent => element('p', {textContent})));
    this.problems.hidden = !this.refused.size;
    this.keep.disabled = this.refused.size > 0 || !Object.keys(this.values).length;
    this.fit.disabled = this.refused.size > 0;
    this.back.disabled = !this.refused.size && !Object.keys(this.values).length;
  }

  // What a fit is asked for: the values, and which of them stay.
  wish() {
    const hold = {};
    for (const key of this.held) {
      const [group, name] = key.split(' ');
      (hold[group] ??= []).push(name);
    }
    return {...this.values, hold};
  }

  draw() {
    const list = element('div', {className: 'sliders'});
    const add = (group, parameters) => {
      list.append(element('div', {}, element('h3', {textContent: capital(this.title(group))}),
        element('ul', {}, ...Object.entries(parameters).filter(([, p]) => !p.derived && !p.idle)
          .map(([name, p]) => this.row(group, name, p)))));
    };
    for (const term of this.model.effects) add(term.effect, term.parameters);
    add('process', this.model.process);
    this.refused = new Map();  // field → why its text is not taken
    this.problems = element('div', {className: 'refused', hidden: true});
    this.problems.setAttribute('role', 'alert');
    this.said = element('p', {className: 'tried'});
    this.said.setAttribute('role', 'status');
    this.keep = button(say('Keep these values'),
      () => this.change(() => post('/api/try?then=keep', this.values)), {disabled: true});
    this.fit = button(say('Fit from here'), () => this.refit(() => post('/api/try?then=refit', this.wish())));
    this.back = button(say('Back to the model'), () => {
      this.charts.tryOut(null);
      this.values = {};
      this.draw();
    }, {disabled: true});
    const details = element('details', {open: $('play').querySelector('details')?.open ?? false},
      element('summary', {textContent: say('Play with the model: move a parameter and watch the curves')}),
      element('p', {className: 'fine', textContent: say('A fit from here leaves what is fixed as it is.')}),
      list, this.problems, this.said, element('p', {className: 'choices'}, this.keep, this.fit, this.back));
    $('play').replaceChildren(details);
    this.say(this.model.rmse, this.model.rmse_validation);
  }

  say(rmse, validation) {
    const now = say('Error {0}, on samples that were not fitted {1}', number(rmse, 4), number(validation, 4));
    this.said.textContent = rmse === this.model.rmse ? now + '.'
      : now + ' ' + say('(the model: {0} and {1}).', number(this.model.rmse, 4), number(this.model.rmse_validation, 4));
  }

  // One question at a time; of those that come meanwhile only the last is asked.
  async ask() {
    this.back.disabled = false;
    this.keep.disabled = this.refused.size > 0;
    if (this.waiting) {
      this.waiting = 'again';
      return;
    }
    this.waiting = 'asked';
    try {
      const began = performance.now(), {values} = this;
      const answer = await post('/api/try', values);
      if (values === this.values) {  // else it is not asked any more
        this.charts.tryOut(answer.simulated);
        this.say(answer.rmse, answer.rmse_validation);
      }
      this.milliseconds = performance.now() - began;
      $('play').dataset.milliseconds = this.milliseconds.toFixed(1);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      complain(error);
    }
    const again = this.waiting === 'again';
    this.waiting = null;
    if (again && Object.keys(this.values).length) this.ask();
  }
}
