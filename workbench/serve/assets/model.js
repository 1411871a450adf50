// What the page says about the model: parts as the server writes them, with buttons.
import {get} from './api.js';
import {$, button, capital, element, number} from './dom.js';
import {say, translate, translated} from './texts.js';
import {reconcile} from './valve.js';

const PARTS = ['tiles', 'ladder', 'steps', 'residual', 'parameters'];

const titles = new Map();  // of effects, by code
export const loadTitles = async () =>
  (await get('/api/effects')).effects.forEach(e => titles.set(e.effect, translated(e.title)));
const LOAD = 'disturbance.measured:';
export const title = code => code === 'process' ? say('process') : code.startsWith(LOAD)
  ? say('the measured load {0}', code.slice(LOAD.length)) : titles.get(code) ?? code;
const titlesOf = codes => codes.map(title).join(say(' and '));

export function clearModel() {
  for (const id of [...PARTS, 'candidates', 'verdict']) $(id).replaceChildren();
}

// Shows the last model. `charts` looks at places, the others are called with codes.
export async function showModel(state, charts, add, preview, remove) {
  const [parts, comparison] = await Promise.all([get('/api/parts'), get('/api/compare')]);
  for (const id of PARTS) {
    $(id).innerHTML = parts[id];
    translate($(id));
  }
  // One point tells nothing about a fall.
  $('fall').hidden = !parts.verdict && state.model.history.length < 2;
  for (const plot of $('ladder').querySelectorAll('.plot')) plot.scrollLeft = plot.scrollWidth;  // the newest step
  showPlaces(comparison.failures, parts.places, charts);
  showCandidates(parts, state, add, preview);
  for (const code of $('parameters').querySelectorAll('td.group code')) {
    const codes = [code.textContent];
    code.after(' ', codeButton(codes, say('Take out'), 'small', remove));
  }
  reconcile(parts.reconciled);
  reachScrolled();
}

// What is wider than the screen can be scrolled with the keyboard.
function reachScrolled() {
  for (const plot of document.querySelectorAll('main .plot')) {
    if (plot.scrollWidth > plot.clientWidth) plot.tabIndex = 0; else plot.removeAttribute('tabindex');
  }
}
addEventListener('resize', reachScrolled);

// The panels stand in the order of the failures; each place in time can be looked at.
function showPlaces(failures, places, charts) {
  const panels = $('residual').querySelectorAll('.panels > div');
  failures.forEach((failure, i) => {
    const [from, to] = places[i] ?? failure.t;
    if (failure.view === 'frequency' || !(to > from) || !panels[i]) return;
    panels[i].append(button(say('Show the worst stretch'), () => {
      charts.lookAt(from, to);
      $('charts').scrollIntoView({block: 'center'});
      $('charts').focus({preventScroll: true});
    }, {className: 'small'}));
  });
}

function showCandidates(parts, state, add, preview) {
  $('candidates').innerHTML = parts.candidates ?? '';
  translate($('candidates'));
  const items = [...$('candidates').querySelectorAll('li[data-effects]')].map(item =>
    ({item, codes: item.dataset.effects.split('\n'),
      accepted: Boolean(item.querySelector('.badge.accepted'))}));
  for (const {item, codes, accepted} of items) {
    item.append(codeButton(codes, accepted ? say('Add to the model') : say('Add anyway'),
      accepted ? 'small primary' : 'small', add), ' ',
    codeButton(codes, say('Preview'), 'small', preview));
  }
  if (parts.verdict === null) {
    $('verdict').replaceChildren();
    return;
  }
  $('verdict').innerHTML = parts.verdict;
  translate($('verdict'));
  if (state.model.belongs_elsewhere) {
    $('verdict').prepend(element('div', {className: 'verdict bad'},
      element('h2', {textContent: say('Fit {0} %: this model belongs to another loop.',
        number(state.model.fit_percent, 4))}),
      element('p', {textContent: say('It says less about this recording than the mean of its output does. Open the recording it was fitted to, {0}, or undo.', state.model.fitted_to)})));
  }
  const [first, ...others] = items.filter(({accepted}) => accepted).map(({codes}) => codes);
  if (!first) return;
  $('verdict').lastElementChild.append(element('div', {className: 'choices'},
    codeButton(first, capital(say('Put {0} into the model', titlesOf(first))), 'primary', add),
    codeButton(first, say('Preview it'), '', preview)));
  if (!others.length) return;
  $('verdict').lastElementChild.append(element('div', {className: 'choices others'},
    ...others.map(codes => codeButton(codes, capital(say('or {0}', titlesOf(codes))), '', add))));
}

const codeButton = (codes, text, className, run) => button(text,
  () => run(codes, titlesOf(codes)), {className, ariaLabel: `${text}: ${titlesOf(codes)}`});

// What a load hides running free: the validation error says little of it, and may rise.
function sayToldAhead(title, {rmse_before, rmse_after}, {rmse_validation_before, rmse_validation_after}) {
  $('added').className = 'good';
  $('added').textContent = say('{0} added: one sample ahead the error falls from {1} to {2}, by {3} %. Running free, where a load hides it, the validation error goes from {4} to {5}.',
    capital(title), number(rmse_before), number(rmse_after), number(100 * (1 - rmse_after / rmse_before)),
    number(rmse_validation_before), number(rmse_validation_after));
  $('added').hidden = false;
}

// Says once what the last addition, or the last fit from values set by hand, brought.
export function showFall(before, model) {
  const step = model.history.at(-1);
  if (before.title && !before.removed && step?.one_sample_ahead) {
    return sayToldAhead(before.title, step.one_sample_ahead, step);
  }
  const fitted = before.together && step;
  if (fitted) before.rmse = fitted.rmse_validation_before;
  const after = model.rmse_validation, percent = 100 * (1 - after / before.rmse);
  const change = Math.abs(percent) < 1 ? say('hardly a change')
    : percent > 0 ? say('down {0} %', number(percent)) : say('up {0} %', number(-percent));
  const values = [number(before.rmse), number(after), change];
  $('added').className = percent >= 1 ? 'good' : '';
  $('added').textContent = (before.removed
    ? say('{0} taken out: validation error {1} to {2}, {3}.', capital(before.title), ...values)
    : before.title
    ? say('{0} added: validation error {1} to {2}, {3}.', capital(before.title), ...values)
    : before.all && model.ended_early ? say('The search has a limit of its own and ended early: validation error {0} to {1}, {2}. Undo takes back one step at a time.', ...values)
    : before.all ? say('All steps are done: validation error {0} to {1}, {2}. Undo takes back one at a time.', ...values)
    : fitted ? say('The model was fitted anew to {0}: validation error {1} to {2}, {3}.', fitted.recording, ...values)
    : say('Fitted from there: validation error {0} to {1}, {2}.', ...values)) +
    (percent <= -1 && !before.removed && !before.all ? ' ' + say('The fitted samples agree better, the others do not: Undo brings back what was before.') : '');
  $('added').hidden = false;
}

// What was stopped, and what the model has now.
export function sayStopped(task, effects) {
  $('added').className = '';
  $('added').textContent = task !== 'ladder' ? say('Stopped: everything is as before.')
    : effects.length ? say('Stopped. The model has what was found until then: {0}. Undo takes back one step at a time.', titlesOf(effects))
    : say('Stopped. No effect was added.');
  $('added').hidden = false;
}

// In place of the model's verdict when the search was stopped.
export function showStopped(again) {
  if ($('verdict').querySelector('.not-explained')) return;
  $('verdict').replaceChildren(element('div', {className: 'verdict not-explained'},
    element('h2', {textContent: say('Not explained yet.')}),
    element('p', {textContent: say('The search for what the model lacks was stopped.')}),
    element('div', {className: 'choices'},
      button(say('Find out what is missing'), again, {className: 'primary'}))));
}
