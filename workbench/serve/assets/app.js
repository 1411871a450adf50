// The page: asks how things stand, shows it, and sends what the user decides.
import {ApiError, get, post, withQuery} from './api.js';
import {Charts} from './charts.js';

const $ = id => document.getElementById(id);
const BUSY_MS = 150, IDLE_MS = 3000;

const charts = new Charts($('charts'));
const titles = new Map();  // of effects, by code
let state = null;
let shown = -1;            // revision that is on the page
let stopped = false;       // the user stopped the search: do not start it again
let opening = false;       // the form is open beside a recording
let timer = 0;
let before = null;         // {rmse, title} while something is being added

const title = code => titles.get(code) ?? code;
const capital = text => text.charAt(0).toUpperCase() + text.slice(1);
const number = (value, digits = 3) => String(Number(value.toPrecision(digits)));

function element(tag, attributes = {}, ...children) {
  const out = Object.assign(document.createElement(tag), attributes);
  out.append(...children);
  return out;
}

function complain(error, heading = 'That did not work.') {
  const detail = error.error ?? {};
  const where = detail.line ? `${detail.file}, line ${detail.line}` +
    (detail.column ? `, column ${detail.column}` : '') : detail.file;
  const parts = [element('h1', {textContent: heading})];
  if (detail.expected) {
    parts.push(element('p', {}, element('strong', {textContent: where + '. '}),
      `Expected ${detail.expected}; found ${detail.found}.`));
    parts.push(element('p', {}, element('strong', {textContent: 'What to do. '}),
      capital(detail.advice.replace('--ts SECONDS', 'the sample period below')) + '.'));
  } else {
    parts.push(element('p', {textContent: capital(error.message)}));
  }
  parts.push(element('button', {type: 'button', textContent: 'Close', onclick: silence}));
  $('alert').replaceChildren(...parts);
  $('alert').hidden = false;
  $('alert').scrollIntoView({block: 'nearest'});
}

function silence() {
  $('alert').hidden = true;
}

// Runs what a click asks for; the answer is the new state.
async function act(work, heading) {
  silence();
  $('added').hidden = true;
  try {
    await show(await work());
  } catch (error) {
    if (!(error instanceof ApiError)) throw error;
    if (error.status) complain(error, heading); else lost();
    if (state) showBar();
  }
  plan();
}

function lost() {
  complain(new Error('It has ended, or was stopped. Start stickband serve again and ' +
    'reload this page.'), 'The program behind this page does not answer.');
}

function plan() {
  clearTimeout(timer);
  timer = setTimeout(poll, state?.job ? BUSY_MS : IDLE_MS);
}

let silent = false;  // the server did not answer
async function poll() {
  if (!document.hidden || state?.job) {
    try {
      const now = await get('/api/state');
      if (silent) silence();
      silent = false;
      await show(now);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      if (error.status) complain(error);
      else if (!silent) lost();
      silent = !error.status;
    }
  }
  plan();
}

async function show(now) {
  const failed = state?.job && !now.job && now.error;
  state = now;
  showBar();
  showWork();
  if (now.revision !== shown && now.recording) await showContent();
  showWork();
  if (failed) {
    before = null;
    stopped ||= !now.model || now.explained === null;
    complain({error: now.error, message: now.error.message},
      now.error.kind === 'cannot_answer' ? 'The data cannot answer that.' : undefined);
  }
  const searching = now.model && now.explained === null && !now.job && !stopped;
  if (searching) await search();
}

async function search() {
  try {
    await show(await post('/api/explain'));
  } catch (error) {
    if (error.status !== 409) throw error;  // 409: another window was faster
  }
}

function showBar() {
  const r = state.recording;
  $('what').textContent = r
    ? `${r.name} · ${r.samples} samples, one every ${number(r.sample_period_s, 6)} s` +
      (state.model ? ` · model of ${state.model.output}` : '')
    : 'the workbench for control valve loops';
  document.title = r ? `${r.name} · Stickband` : 'Stickband';
  $('actions').hidden = !r;
  $('work').hidden = !r;
  for (const part of document.querySelectorAll('.of-model')) part.hidden = !state.model;
  $('open').hidden = Boolean(r) && !opening;
  $('open-title').textContent = r ? 'Open another recording'
    : 'Which physical effect is your model missing?';
  $('open-other').setAttribute('aria-expanded', String(opening));
  $('keep-label').hidden = !state.model;
  const changing = state.job && state.job.task !== 'explain';
  $('undo').disabled = !state.can_undo || Boolean(changing);
  $('climb').disabled = !state.model || Boolean(changing);
  for (const [id, ready] of [['save-model', state.model],
                             ['save-report', state.explained !== null]]) {
    $(id).setAttribute('aria-disabled', String(!ready));
  }
}

// What depends on the model alone; once for each revision.
async function showContent() {
  const revision = state.revision;
  const signals = await get('/api/signals');
  charts.show(signals);
  $('thinned').hidden = signals.samples === signals.t.length;
  $('thinned').textContent =
    `Drawn from ${signals.t.length} of ${signals.samples} samples; every peak is kept.`;
  $('notes').replaceChildren(
    ...state.recording.notes.map(note => element('li', {textContent: note})));
  $('notes-section').hidden = !state.recording.notes.length;
  if (state.model) {
    const [parts, comparison] = await Promise.all([get('/api/parts'), get('/api/compare')]);
    for (const id of ['tiles', 'ladder', 'steps', 'residual', 'parameters']) {
      $(id).innerHTML = parts[id];
    }
    showPlaces(comparison.failures);
    showCandidates(parts);
    showFall();
  } else {
    for (const id of ['tiles', 'ladder', 'steps', 'residual', 'parameters', 'candidates',
                      'verdict']) {
      $(id).replaceChildren();
    }
  }
  shown = revision;
}

// The panels stand in the order of the failures; each place in time can be looked at.
function showPlaces(failures) {
  const panels = $('residual').querySelectorAll('.panels > div');
  failures.forEach((failure, i) => {
    const [from, to] = failure.t;
    if (failure.view === 'frequency' || !(to > from) || !panels[i]) return;
    const button = element('button', {type: 'button', className: 'small',
      textContent: 'Show the worst stretch'});
    button.onclick = () => {
      charts.lookAt(from, to);
      $('charts').scrollIntoView({block: 'center'});
      $('charts').focus({preventScroll: true});
    };
    panels[i].append(button);
  });
}

function showCandidates(parts) {
  $('candidates').innerHTML = parts.candidates ?? '';
  for (const item of $('candidates').querySelectorAll('li[data-effects]')) {
    const codes = item.dataset.effects.split(' ');
    const accepted = item.querySelector('.badge.accepted');
    item.append(addButton(codes, accepted ? 'Add to the model' : 'Add anyway',
                          accepted ? 'small primary' : 'small'));
  }
  if (parts.verdict === null) return;
  $('verdict').innerHTML = parts.verdict;
  const supported = [...$('candidates').querySelectorAll('li[data-effects]')]
    .filter(item => item.querySelector('.badge.accepted'))
    .map(item => item.dataset.effects.split(' '));
  const row = element('div', {className: 'choices'});
  supported.forEach((codes, i) => {
    const name = codes.map(title).join(' and ');
    row.append(addButton(codes, i ? `or ${name}` : `Add ${name}`, i ? '' : 'primary'));
  });
  if (supported.length) $('verdict').firstElementChild.append(row);
}

function addButton([effect, ...partners], text, className) {
  const button = element('button', {type: 'button', className, textContent: text});
  button.setAttribute('aria-label', `${text}: ${[effect, ...partners].map(title).join(' with ')}`);
  button.onclick = () => {
    before = {rmse: state.model.rmse_validation,
              title: [effect, ...partners].map(title).join(' and ')};
    stopped = false;
    $('verdict').focus();  // the button is about to go
    act(() => post('/api/add', {effect, with: partners}));
  };
  return button;
}

// Says once what the last addition brought.
function showFall() {
  if (!before || state.model.effects.length === 0) return;
  const after = state.model.rmse_validation, percent = 100 * (1 - after / before.rmse);
  const change = Math.abs(percent) < 1 ? 'hardly a change'
    : percent > 0 ? `down ${number(percent)} %` : `up ${number(-percent)} %`;
  $('added').className = percent >= 1 ? 'good' : '';
  $('added').textContent = `${capital(before.title)} added: validation error ` +
    `${number(before.rmse)} to ${number(after)}, ${change}.`;
  $('added').hidden = false;
  before = null;
}

const TASKS = {
  model: 'Fitting a textbook model',
  explain: 'Looking for what is missing',
  add: 'Adding the effect and fitting everything again',
  ladder: 'Explaining and adding, step by step',
};

// The box on top while work goes on or was stopped.
function showWork() {
  const job = state.job;
  document.body.classList.toggle('busy', Boolean(job));
  const buttons = document.querySelectorAll('#candidates button, #verdict .choices button');
  for (const button of buttons) button.disabled = Boolean(job);
  if (!job) {
    if (state.model && state.explained === null && stopped) showStopped();
    return;
  }
  let box = $('working');
  if (!box) {
    box = element('div', {id: 'working', className: 'verdict'}, element('h1'), element('p'),
      element('progress'), element('button', {type: 'button', textContent: 'Stop'}));
    box.querySelector('button').onclick = () => {
      stopped = true;
      before = null;
      act(() => post('/api/cancel'));
    };
    $('verdict').replaceChildren(box);
  }
  box.querySelector('h1').textContent = job.task === 'add' && before
    ? `Adding ${before.title}…` : `${TASKS[job.task] ?? job.task}…`;
  box.querySelector('p').textContent = job.task === 'add'
    ? 'Everything is fitted again.' : job.detail
    ? `Trying ${title(job.detail)}` + (job.of ? `, ${job.number} of ${job.of}` : '') +
      (job.seconds >= 2 ? `, ${Math.round(job.seconds)} s` : '')
    : '';
  const bar = box.querySelector('progress');
  if (job.of && job.task === 'explain') {
    bar.max = job.of;
    bar.value = job.number - 1;
  } else {
    bar.removeAttribute('value');
  }
}

function showStopped() {
  const again = element('button', {type: 'button', className: 'primary',
    textContent: 'Find out what is missing'});
  again.onclick = () => {
    stopped = false;
    act(() => post('/api/explain'));
  };
  $('verdict').replaceChildren(element('div', {className: 'verdict'},
    element('h1', {textContent: 'Not explained yet.'}),
    element('p', {textContent: 'The search for what the model lacks was stopped.'}), again));
}

function openFile(file) {
  if (!file) return;
  stopped = false;
  before = null;
  const name = file.name;
  if (/\.json$/i.test(name)) {
    act(() => post(withQuery('/api/model', {name}), file), `${name} cannot be used as a model.`);
    return;
  }
  $('what').textContent = `Opening ${name}…`;
  const keep = !$('keep-label').hidden && $('keep').checked ? '1' : '';
  act(async () => {
    const now = await post(withQuery('/api/recording', {name, keep,
      ts: $('ts').value.trim().replace(',', '.'), output: $('output').value}), file);
    opening = false;
    $('keep').checked = false;
    return now;
  }, `${name} cannot be used.`);
}

$('file').onchange = () => {
  openFile($('file').files[0]);
  $('file').value = '';
};
for (const type of ['dragenter', 'dragover']) {
  document.addEventListener(type, event => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
}
document.addEventListener('dragleave', event => {
  if (!event.relatedTarget) document.body.classList.remove('dropping');
});
document.addEventListener('drop', event => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  openFile(event.dataTransfer.files[0]);
});
$('example').onclick = () => {
  stopped = false;
  act(async () => {
    const now = await post('/api/example');
    opening = false;
    return now;
  });
};
$('open-other').onclick = () => {
  opening = !opening;
  showBar();
  if (opening) $('open').scrollIntoView({block: 'nearest'});
};
$('undo').onclick = () => {
  stopped = false;
  before = null;
  act(() => post('/api/undo'));
};
$('climb').onclick = () => {
  stopped = false;
  before = null;
  act(async () => {
    if (state.job) await post('/api/cancel');
    return post('/api/ladder');
  });
};
for (const link of ['save-model', 'save-report']) {
  $(link).onclick = event => {
    if ($(link).getAttribute('aria-disabled') === 'true') event.preventDefault();
  };
}
for (const button of document.querySelectorAll('[data-zoom]')) {
  button.onclick = () => charts.zoom(button.dataset.zoom);
}
document.addEventListener('visibilitychange', () => {
  if (!document.hidden) poll();
});

get('/api/effects')
  .then(answer => answer.effects.forEach(e => titles.set(e.effect, e.title)))
  .then(poll, lost);
