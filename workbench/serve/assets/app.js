// The page: asks how things stand, shows it, and sends what the user decides.
import {complain, lost, silence} from './alert.js';
import {ApiError, GivenUp, download, get, post, withQuery} from './api.js';
import {Beside, inksOf} from './beside.js';
import {Charts} from './charts.js';
import {$, duration, element, number} from './dom.js';
import {setOpens} from './direction.js';
import {showDoing, stop} from './doing.js';
import {Elsewhere} from './elsewhere.js';
import {showFacts} from './facts.js';
import {clearModel, loadTitles, sayStopped, showFall, showModel, showStopped, title} from './model.js';
import {Models} from './models.js';
import {Opening} from './opening.js';
import {Play} from './play.js';
import {Preview, preview} from './preview.js';
import {Range} from './range.js';
import {showScatter} from './scatter.js';
import {Split} from './split.js';
import {Take} from './take.js';
import {LANGUAGES, choose, language, say, translate, translated} from './texts.js';
import {showValve} from './valve.js';

const BUSY_MS = 150, IDLE_MS = 3000;

if (window.uPlot) $('unloaded').remove();

const charts = new Charts($('charts'), $('overview'));
let state = null;
let shown = '';            // what is on the page: revision and verdict
let drawn = 0;             // what is in the charts
let blocks = [];           // of their samples
let stopped = false;       // the user stops the search: do not start it again
let timer = 0;
let before = null;         // {rmse, title} while something is being added
let asking = 0;            // of what was clicked and the server has not answered
let turn = 0;              // begun and answered

// Runs what a click asks for; the answer is the new state.
async function act(work, heading, ofFile = false) {
  silence();
  $('added').hidden = true;
  try {
    await show(await asked(work));
  } catch (error) {
    if (error instanceof GivenUp) return;
    if (!(error instanceof ApiError)) throw error;
    await failed(error, heading, ofFile);
    if (state) showBar();
  }
  plan();
}

async function failed(error, heading, ofFile) {
  if (error.error.kind === 'other_open') {
    await look();
    if (!$('elsewhere').hidden) elsewhere.point();
  } else if (error.status) {
    // 409: it is not the file that is at fault.
    complain(error, error.status === 409 ? undefined : heading, ofFile);
  } else {
    lost(elsewhere.holds());
  }
}

async function saveFrom(path) {
  silence();
  try {
    await download(path);
  } catch (error) {
    if (!(error instanceof ApiError)) throw error;
    await failed(error, say('That was not saved.'));
  }
}

// What the server says meanwhile is of before, and ends nothing that was asked for.
async function asked(work) {
  ++turn;
  ++asking;
  try {
    return await work();
  } finally {
    --asking;
    ++turn;
  }
}

// A change of the recording or of the model that the user asks for.
function change(work, heading, ofFile = false) {
  stopped = false;
  before = null;
  return act(work, heading, ofFile);
}

function refit(work) {
  return change(() => {
    before = {rmse: state.model.rmse_validation};
    return work();
  });
}

const parts = [new Play(charts, change, title, refit), new Models(charts, title),
  new Preview(charts, title, add), new Beside(act, together, file => opening.takeBeside(file)), new Take(charts, saveFrom)];
const split = new Split(change);
const range = new Range(charts, change);
const elsewhere = new Elsewhere(act);
const opening = new Opening({change, act, state: () => state, redraw: () => showBar()});

// Which of the recordings beside are fitted, too.
function together(work) {
  return change(() => {
    before = {together: true};
    return work();
  });
}

function plan() {
  clearTimeout(timer);
  timer = setTimeout(poll, state?.job || state?.verdict_job ? BUSY_MS : IDLE_MS);
}

let silent = false;  // the server did not answer
async function poll() {
  try {
    await look();
  } finally {
    plan();
  }
}

async function look() {
  if (!document.hidden || state?.job) {
    try {
      const since = turn;
      const now = await get('/api/state');
      if (silent) silence();
      silent = false;
      if (since === turn) await show(now);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      if (error.status) complain(error);
      else if (!silent) lost(elsewhere.holds());
      silent = !error.status;
    }
  }
}

async function show(now) {
  if (elsewhere.tells(now, state)) return;
  const failed = state?.job && !now.job && now.error;
  if (state && now.opened !== state.opened && state.job?.task !== 'together') scrollTo(0, 0);
  state = now;
  setOpens(now.opens);
  showBar();
  showWork();
  await fetched(() => showValve(state, opens => act(() => post('/api/direction', {opens}))));
  const key = state.recording ? `${state.revision} ${state.verdict}` : '';
  if (key && key !== shown && await fetched(showContent)) shown = key;
  showWork();
  if (failed) {
    before = null;
    stopped ||= !now.model || now.explained === null;
    complain({error: now.error, message: now.error.message},
      now.error.kind === 'cannot_answer' ? say('The data cannot answer that.') : undefined);
  }
  // The verdict has the machine to itself until it is there.
  elsewhere.keep(now);
  const searching = now.model && now.explained === null && !now.job && !now.verdict_job &&
    !stopped && !now.stopped;
  if (searching) await search();
}

// False where what is asked for is gone meanwhile: the next look at the state will tell.
async function fetched(work) {
  try {
    await work();
    return true;
  } catch (error) {
    if (error.status !== 409) throw error;
    return false;
  }
}

async function search() {
  try {
    await show(await post('/api/explain?unasked=1'));
  } catch (error) {
    if (error.status !== 409) throw error;  // 409: another window was faster, or stopped it
  }
}

function showBar() {
  const r = state.recording;
  $('what').textContent = r
    ? r.name + (r.tags ? ` (${r.tags})` : '') + ' · ' + say('{0} samples, one every {1} s', r.samples, number(r.sample_period_s, 6)) +
      ` · ${duration(r.samples * r.sample_period_s)}` +
      (r.start ? ' · ' + say('from {0}', r.start.replace('T', ' ')) : '')
    : say('the workbench for control valve loops');
  document.title = r ? `${r.name} · Stickband` : 'Stickband';
  $('actions').hidden = !r;
  $('work').hidden = !r;
  for (const part of document.querySelectorAll('.of-model')) {
    // Those without content have nothing to say about this model.
    part.hidden = !state.model || !part.children.length;
  }
  opening.show();
  range.show(state);
  const changing = state.job && state.job.task !== 'explain';
  $('undo').disabled = !state.can_undo || Boolean(changing);
  $('redo').disabled = !state.can_redo || Boolean(state.job);
  $('climb').disabled = !state.model || Boolean(changing);
  $('save-report').disabled = state.explained === null;
}

async function showSignals() {
  const count = state.drawn;
  const signals = await get('/api/signals');
  charts.show(signals, state.recording, inksOf(state));
  $('thinned').hidden = signals.samples === signals.t.length;
  $('thinned').textContent = say('Drawn from {0} of {1} samples; every peak is kept.',
    signals.t.length, signals.samples);
  showScatter(signals, state.recording.units);
  const outside = ([from, to, kind]) => kind === 'manual' &&
    !signals.left_out.some(([first, last]) => first <= from && to <= last);
  showFacts(signals.marks, charts, signals.marks.some(outside)
    ? () => change(() => post('/api/leave_out', {manual: true})) : null);
  blocks = signals.blocks;
  drawn = count;
}

// What depends on the recording and the model; once for each.
async function showContent() {
  if (drawn !== state.drawn) await showSignals();
  $('notes').replaceChildren(...state.recording.notes.map(note =>
    element('li', {textContent: translated(note).replace('--ts SECONDS', say('the sample period'))})));
  $('notes-section').hidden = !state.recording.notes.length;
  if (!state.model) return clearModel();
  await showModel(state, charts, add, see, remove);
  split.show(state, blocks);
  for (const part of parts) await part.show(state);
  if (before && !asking && !state.job && (state.model.effects.length || before.removed || !before.title)) {
    showFall(before, state.model);
    before = null;
  }
}

function add([effect, ...partners], name) {
  before = {rmse: state.model.rmse_validation, title: name};
  stopped = false;
  $('verdict').focus();  // the button is about to go
  act(() => post('/api/add', {effect, with: partners}));
}

function remove([effect], name) {
  before = {rmse: state.model.rmse_validation, title: name, removed: true};
  stopped = false;
  $('verdict').focus();
  act(() => post('/api/remove', {effect}));
}

function see(codes, name) {
  before = null;
  stopped = false;
  act(() => preview(codes), say('{0} cannot be previewed.', name));
}

function showWork() {
  const job = state.job;
  showDoing(job, title, before?.title);
  const buttons = document.querySelectorAll(
    '#candidates button, #verdict .choices button, #parameters button');
  for (const button of buttons) button.disabled = Boolean(job);
  if (!job && state.model && state.explained === null && (stopped || state.stopped)) {
    showStopped(() => change(() => post('/api/explain')));
  }
}

$('stop').onclick = async () => {
  const {task} = state.job, {drawn} = state;
  stopped = true;
  before = null;
  stop(state.job, title);
  await act(() => post('/api/cancel'));
  // What was done just before stays done; of a ladder it is told.
  const stays = task === 'ladder' || state.drawn === drawn;
  if (state.model && task !== 'explain' && stays) sayStopped(task, state.model.effects);
};
$('undo').onclick = () => change(() => post('/api/undo'));
$('redo').onclick = () => change(() => post('/api/redo'));
$('climb').onclick = () => change(async () => {
  if (state.job) await post('/api/cancel');
  before = {rmse: state.model.rmse_validation, all: true};
  return post('/api/ladder');
});
$('save-report').onclick = () => saveFrom(withQuery('/api/report', {language}));
for (const button of document.querySelectorAll('[data-zoom]')) {
  button.onclick = () => charts.zoom(button.dataset.zoom);
}
document.addEventListener('visibilitychange', () => {
  if (!document.hidden) poll();
});
addEventListener('focus', poll);

document.documentElement.lang = language;
for (const [code, name] of Object.entries(LANGUAGES)) {
  $('language').append(element('option', {value: code, textContent: name, selected: code === language}));
}
$('language').onchange = () => choose($('language').value);
translate(document.body);
loadTitles().then(poll, () => lost(false));
