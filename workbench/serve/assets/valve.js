// The verdict on the valve: one line, its band, what to do, and the pictures that show it.
import {get} from './api.js';
import {$, drawn, duration, element, number, select, withUnit} from './dom.js';
import {ANSWERS, bandNames, ofValve, opens} from './direction.js';
import {say, translated} from './texts.js';
import {clockOf, clockText, dayText, unitFor} from './times.js';
import {picture} from './xy.js';

let shown = '';  // what the box says: recording, first look or all, words

const percent = value => `${number(value, value < 10 ? 2 : 3)}\u00a0%`;

// One stroke, or both where they are alike.
function bands({ascending, descending}) {
  const alike = ascending && descending && ascending.value === descending.value;
  if (alike) return [[say('Stick band'), ascending]];
  const [rising, falling] = bandNames();
  return [[rising, ascending], [falling, descending]].filter(([, band]) => band);
}

// From 0 to 100 % of the span of u: the interval as a bar, the value as a line.
function scale(band, ink) {
  const at = share => 2 + 196 * Math.min(Math.max(share, 0), 100) / 100;
  const low = at(band.percent_low), high = at(band.percent_high);
  return drawn('svg', {viewBox: '0 0 200 14', class: 'scale', preserveAspectRatio: 'none', 'aria-hidden': 'true'},
    drawn('path', {class: 'rail', d: 'M2 7H198'}),
    drawn('rect', {class: ink, x: low, y: 3, width: Math.max(high - low, 2), height: 8, rx: 2}),
    drawn('path', {class: 'value', d: `M${at(band.percent)} 0V14`}));
}

function bandLine(name, band, unit, ink) {
  return element('div', {className: 'band'},
    element('p', {}, element('strong', {textContent: `${name} ${number(band.value)}${unit}`}),
      ' ' + say('in u, between {0} and {1} (95 %): {2} of the range of u in this recording',
        number(band.low), number(band.high) + unit, percent(band.percent))),
    scale(band, ink));
}

function pictures(valve, {units, start, from_s: first, samples, sample_period_s: period}) {
  const p = valve.picture;
  if (!p) return [];
  const uLabel = withUnit(say('controller output u'), units.u);
  const out = [];
  if (p.stem && valve.mood !== 'open') {
    // By the clock from where the picture begins, else as in the charts.
    const clock = clockOf(start), begin = p.t[0], span = p.t.at(-1) - begin;
    const [size, unit] = unitFor(clock === null ? samples * period : span);
    const t = p.t.map(value => (value - (clock === null ? 0 : begin)) / size);
    const at = clock === null ? 0 : clock + begin - first;
    const day = samples * period >= 86400 ? dayText(at) + ' ' : '';
    out.push(picture({
      title: say('The valve: what is asked and where the stem is'),
      xLabel: clock === null ? say('time, {0}', unit) : say('time, {0} from {1}', unit, day + clockText(at, span < 7200)),
      yLabel: withUnit('u', units.u),
      lines: [
        {label: say('controller output u'), ink: 'measured', x: t, y: p.u},
        {label: say('stem, identified'), ink: 'valve', broad: true,
          x: t, y: p.stem}],
      caption: valve.mood === 'bad'
        ? say('Where the stem is flat while u moves on, the valve is stuck.')
        : say('The stem follows the controller output.')}));
  }
  out.push(picture({
    title: say('Process output over controller output'),
    xLabel: uLabel, yLabel: withUnit(say('process output y'), units.y),
    lines: [{label: 'y', ink: 'two-path', x: p.u, y: p.y}],
    caption: valve.mood === 'bad'
      ? say('A sticking valve draws a parallelogram: u runs on while y waits.') : ''}));
  return out;
}

function seen(valve) {
  const band = valve.detectable_band;
  if (!(band?.value > 0) && valve.mood === 'bad') return '';
  if (!(band?.value > 0)) return say('This recording does not tell from what size on a stick band would have been seen.');
  return say('A stick band above {0} in u, {1} of its range in this recording, would have shown.',
    number(band.value), percent(band.percent_of_span));
}

// The third question, of the recording that is open.
function direction(valve, sayOpens) {
  if (!bands(valve.band).length) return [];
  const choice = select(ANSWERS(), opens(), sayOpens, {id: 'direction'});
  return [element('label', {className: 'fine'}, say('Does a higher output open the valve?') + ' ', choice)];
}

function card(valve, recording, sayOpens) {
  const unit = recording.units.u ? ` ${recording.units.u}` : '';
  const said = element('div', {className: 'said'},
    element('p', {className: 'so-far', hidden: true}),
    element('h1', {textContent: translated(valve.headline)}),
    ...bands(valve.band).map(([name, band]) => bandLine(name, band, unit, valve.mood)));
  const reason = ofValve(valve.reason) ?? translated(valve.reason);
  // Without advice of its own the reason says what to do.
  said.append(valve.advice
    ? element('p', {className: 'todo'}, element('strong', {textContent: say('What to do.') + ' '}),
      translated(valve.advice))
    : element('p', {className: 'todo', textContent: reason}));
  said.append(element('p', {id: 'reconciled', className: 'reconciled', hidden: true}));
  const why = element('div', {className: 'why'});
  if (valve.advice) why.append(element('p', {textContent: reason}));
  if (valve.cause) why.append(element('p', {textContent: translated(valve.cause)}));
  const o = valve.identification.oscillation;
  why.append(element('p', {className: 'fine'}, seen(valve) + ' ' + (o.detected
    ? say('Oscillation of u: period {0}, {1} cycles.', duration(o.period_s), Math.round(o.cycles))
    : say('No oscillation is seen in u.'))), ...direction(valve, sayOpens));
  return [said, element('div', {className: 'pictures'}, ...pictures(valve, recording)), why];
}

// One window has been looked at; what the others say may change the verdict.
function showSoFar(line, state, job) {
  const now = state.verdict ? '' : job?.of > 1
    ? say('First look, at one part of the recording; now part {0} of {1}…', job.number, job.of)
    : say('First look, at one part of the recording; the others follow…');
  line.hidden = !now;
  if (line.textContent !== now) line.textContent = now;
}

// Keeps the box in step with the state of the server.
// `sayOpens` takes another answer to the third question.
export async function showValve(state, sayOpens) {
  const box = $('valve');
  box.hidden = !state.recording;
  if (!state.recording) return;
  const job = state.verdict_job;
  if (state.verdict || state.verdict_so_far) {
    const key = [state.opened, Boolean(state.verdict), opens()].join();
    if (shown !== key) {
      const valve = await get('/api/valve');
      const focused = document.activeElement?.id === 'direction';
      shown = key;
      box.className = `verdict ${valve.mood}`;
      box.replaceChildren(...card(valve, state.recording, sayOpens));
      if (focused) $('direction')?.focus();
    }
    showSoFar(box.querySelector('.so-far'), state, job);
    return;
  }
  shown = '';
  const now = !job ? state.verdict_error
      ? say('No verdict on the valve: {0}', translated(state.verdict_error.message))
      : say('No verdict on the valve: this recording has no process output y.')
    : job.of > 1 ? say('Does the valve stick? Looking at window {0} of {1}…', job.number, job.of)
    : say('Does the valve stick? Looking…');
  if (box.dataset.waits !== now || !box.querySelector('.waits')) {
    box.className = 'verdict';
    box.dataset.waits = now;
    const bar = element('progress', {ariaLabel: say('Progress'), hidden: !job});
    if (job?.of > 1) Object.assign(bar, {max: job.of, value: job.number - 1});
    box.replaceChildren(element('h1', {className: 'waits', textContent: now}), bar);
  }
}

// Where verdict and model seem to disagree.
export function reconcile(sentence) {
  const line = $('reconciled');
  if (!line) return false;
  line.hidden = !sentence;
  line.textContent = sentence ? translated(sentence) : '';
  return true;
}
