// The chooser: what a file holds, a plot of each signal, and which of them is what.
import {complain, silence} from './alert.js';
import {ApiError, GivenUp, post, withQuery} from './api.js';
import {$, button, drawn, element, number, select} from './dom.js';
import {say, translated} from './texts.js';

const ROLES = ['u', 'y', 'sp', 'x'], LOAD = 'load';
const UNITS = ['s', 'ms', 'µs', 'min', 'h'];
const WIDTH = 240, HEIGHT = 44;

const roleText = role => ({
  u: say('u, controller output (OP)'), y: say('y, process output (PV)'),
  sp: say('sp, setpoint'), x: say('x, valve position'), [LOAD]: say('a measured load'),
  '': say('not used')})[role];

function spark({points, low, high}) {
  const last = points.at(-1)?.[0] || 1, span = high - low || 1;
  const d = points.map(([k, v], i) => (i ? 'L' : 'M') +
    (2 + (WIDTH - 4) * k / last).toFixed(1) + ' ' +
    (HEIGHT - 3 - (HEIGHT - 6) * (v - low) / span).toFixed(1)).join('');
  return drawn('svg', {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none',
    'aria-hidden': 'true'}, drawn('path', {class: 'line two-path', d}));
}

const labelled = (label, ...choice) =>
  element('label', {}, element('span', {textContent: label + ' '}), select(...choice));

const marks = () => [['point', say('a decimal point')], ['comma', say('a decimal comma')]];
const orders = () => [['dmy', say('day, month, year')], ['mdy', say('month, day, year')],
  ['ymd', say('year, month, day')]];

// Shows what `file` holds and calls open(query) with the user's choice. Throws ApiError.
export class Columns {
  constructor(open) {
    this.open = open;
  }

  hide() {
    $('columns').hidden = true;
    this.file = null;
  }

  // `beside`: to lie beside the recording that is open.
  async show(file, query, problem = null, beside = this.file === file && this.beside) {
    if (file !== this.file) this.loads = new Set();
    this.taken = '';
    Object.assign(this, {file, beside, query: {...query}});
    const found = await post(withQuery('/api/columns', {name: file.name, ...this.query}), file);
    if (this.file !== file) throw new GivenUp();
    this.found = found;
    if (this.found.time) this.query.time = this.found.time;
    this.roles = {...this.found.picked};  // role → name of a signal
    // Without signals to choose from, why there are none comes first.
    this.problem = (!this.found.signals.length && this.found.problem) || (problem?.error ?? this.found.problem);
    this.draw();
    $('columns').hidden = false;
    $('columns').scrollIntoView({block: 'start'});
    $('columns').querySelector(this.asksForDates() || this.asksForMark()
      ? '.dates button' : 'select, button')
      ?.focus({preventScroll: true});
  }

  // Dates with two readings: one click tells.
  asksForDates() {
    return /^dates/.test(this.problem?.expected ?? '');
  }

  // Numbers with two readings, likewise.
  asksForMark() {
    return /--decimal/.test(this.problem?.advice ?? '');
  }

  dates() {
    const offer = (key, choices) => [element('p', {className: 'choices dates'}, ...choices.map(([value, text]) =>
      button(text, () => this.again({[key]: value}), {className: 'primary'})))];
    if (this.asksForMark()) return offer('decimal', marks());
    if (!this.asksForDates()) return [];
    const offered = orders().filter(([order]) => this.problem.advice?.includes(order));
    return offer('date_order', offered.length ? offered : orders());
  }

  async again(change) {
    try {
      await this.show(this.file, {...this.query, ...change});
      silence();
    } catch (error) {
      if (error instanceof GivenUp) return;
      if (!(error instanceof ApiError)) throw error;
      complain(error, say('{0} cannot be used.', this.found.name));
    }
  }

  roleOf(name) {
    return ROLES.find(role => this.roles[role] === name) ?? (this.loads.has(name) ? LOAD : '');
  }

  choose(name, role) {
    const former = ROLES.includes(role) && this.roles[role] !== name && this.roles[role];
    this.taken = former ? say('{0} is {1} now; {2} was, and is not used any more.', name, role, former) : '';
    for (const other of ROLES) {
      if (this.roles[other] === name || other === role) delete this.roles[other];
    }
    this.loads.delete(name);
    if (role === LOAD) this.loads.add(name); else if (role) this.roles[role] = name;
    this.draw();
    [...$('columns').querySelectorAll('select[data-signal]')]
      .find(box => box.dataset.signal === name)?.focus();
  }

  card(signal) {
    const role = this.roleOf(signal.name);
    const name = signal.unit && !signal.name.includes(signal.unit)
      ? `${signal.name} [${signal.unit}]` : signal.name;
    const box = select(['', ...ROLES, LOAD].map(value => [value, roleText(value)]), role,
      value => this.choose(signal.name, value), {ariaLabel: say('{0} is', name)});
    box.dataset.signal = signal.name;
    return element('li', {className: role ? 'chosen' : ''},
      element('strong', {textContent: name}), spark(signal),
      element('span', {className: 'fine', textContent:
        say('{0} to {1}', number(signal.low, 4), number(signal.high, 4))}), box);
  }

  times() {
    const out = element('p', {className: 'options'});
    const columns = this.found.columns.map((name, i) => [`#${i + 1}`, name]);
    const [, column, unit = ''] = /^(.*?)(?: \[(.*)\])?$/.exec(this.query.time ?? '');
    out.append(labelled(say('Time is'), [['', say('found by itself')], ...columns],
      column, value => this.again({time: value, ts: ''})));
    // Dates need none.
    if (column && !this.found.start) {
      out.append(labelled(say('counted in'), [['', say('the unit of its name, or s')], ...UNITS.map(name => [name, name])],
        unit, value => this.again({time: value ? `${column} [${value}]` : column, ts: ''})));
    }
    out.append(labelled(say('Dates are'), [['', say('recognised automatically')],
      ...orders()], this.query.date_order ?? '',
    value => this.again({date_order: value})));
    out.append(labelled(say('Decimal mark'), [['', say('recognised automatically')],
      ...marks()], this.query.decimal ?? '',
    value => this.again({decimal: value})));
    const period = element('input', {type: 'text', inputMode: 'decimal', size: 6,
      value: this.query.ts ?? '', autocomplete: 'off'});
    period.onchange = () => this.again({ts: period.value.trim().replace(',', '.'), time: ''});
    out.append(element('label', {},
      element('span', {textContent: say('or a sample every') + ' '}), period, ' s'));
    return out;
  }

  rests(name) {
    const signal = this.found.signals.find(other => other.name === name);
    return signal && signal.low === signal.high;
  }

  // Loops that the tags tell, each with one click.
  loops() {
    const {loops} = this.found;
    if (loops.length < 2) return [];
    return [element('p', {className: 'choices loops'},
      element('span', {textContent: say('Open the loop')}), ...loops.map(({name, ...roles}) => {
        const still = ['u', 'y'].find(role => this.rests(roles[role])), title = name || `${roles.u}, ${roles.y}`;
        return button(still ? say('{0}: {1} does not move', title, still) : title,
          () => this.use(roles), {disabled: Boolean(still)});
      }))];
  }

  use(roles) {
    const loads = [...this.loads].filter(name => !Object.values(roles).includes(name));
    this.open(this.file, {...this.query, ...roles, load: loads.join('\n')});
  }

  // Why these columns cannot be used yet.
  lacks() {
    if (!this.found.signals.length) return '';
    if (this.found.needs_time) return say('Say which column has the times, or how far the samples are apart.');
    if (!this.roles.u) return say('Say which signal is u, the controller output.');
    return this.roles.y || this.roles.x ? '' : say('Say which signal is y, the process output.');
  }

  draw() {
    const {found} = this, list = element('ul', {className: 'signals'});
    for (const signal of found.signals) list.append(this.card(signal));
    const ready = this.roles.u && (this.roles.y || this.roles.x) && !found.needs_time;
    const go = button(say('Use these columns'), () => this.use(this.roles),
      {className: 'primary', disabled: !ready});
    const said = [this.taken, this.lacks()].filter(Boolean).join(' ');
    const why = element('p', {id: 'columns-why', className: 'fine', textContent: said, hidden: !said});
    why.setAttribute('role', 'status');
    const rest = button(say('All others are loads'), () => {
      found.signals.forEach(({name}) => this.roleOf(name) || this.rests(name) || this.loads.add(name));
      this.draw();
    });
    const cancel = button(say('Cancel'), () => this.hide());
    const what = [element('h1', {id: 'columns-title',
      textContent: this.asksForDates()
      ? say('How are the dates of {0} written?', found.name) : say('Which columns of {0}?', found.name)})];
    if (this.problem) {
      what.push(element('p', {className: 'problem', textContent: this.problem.expected
        ? say('Expected {0}; found {1}.', translated(this.problem.expected), translated(this.problem.found))
        : translated(this.problem.message)}));
    }
    if (found.signals.length) {
      const rows = found.needs_time
        ? say('{0} rows, and no column of times: say which one it is, or how far the samples are apart.', found.rows)
        : say('{0} rows, one every {1} s', found.rows, number(found.sample_period_s, 6)) +
          (found.start ? ', ' + say('from {0}', found.start.replace('T', ' ')) : '') + '.';
      what.push(element('p', {textContent: rows + (found.signals.length < 2 ? '' : ' ' +
        say('Say which signal is the controller output u and which the process output y; what else may move y is a measured load.'))}));
    }
    if (found.signals.length < 2) {
      what.push(element('p', {textContent: say('Read so, the file has fewer than two signals. Choose another column of times, or export it as a table with a column of its own for each signal.')}));
    }
    $('columns').replaceChildren(...what, ...this.dates(), ...this.loops(), this.times(), list, why,
      element('p', {className: 'choices'}, go, ' ', rest, ' ', cancel));
  }
}
