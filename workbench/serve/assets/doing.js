// The box that tells of work under way, with its Stop. It lies beside what it changes, so
// that whatever stood there stays when the work is stopped.
import {$, capital} from './dom.js';
import {say, translated} from './texts.js';

const TASKS = {
  model: 'Fitting a textbook model',
  explain: 'Looking for what is missing',
  add: 'Adding the effect and fitting everything again',
  remove: 'Taking the effect out and fitting the rest again',
  refit: 'Fitting from these values',
  together: 'Fitting to the recordings chosen',
  preview: 'Fitting the effect for a preview',
  ladder: 'Explaining and adding, step by step',
};

let stopping = false;  // this page asked; the server may still be on its way

// The last candidate is long done when pairs are tried, of which the server counts nothing.
let last = {key: '', since: 0};
function triesPairs(job) {
  const key = `${job.task} ${job.detail} ${job.number}`;
  if (key !== last.key || job.seconds < last.since) last = {key, since: job.seconds};
  const usual = job.number > 0 ? last.since / job.number : 0;
  return job.of > 0 && job.number >= job.of && job.seconds - last.since > Math.max(0.5, 2 * usual);
}

// A search counts its candidates up; where the ladder begins again, it is at its next step.
let count = {task: '', number: 0, step: 1, seconds: 0};
function stepOf({task, number, seconds}) {
  if (task !== count.task || seconds < count.seconds) {
    count = {task, number, step: 1, seconds};
  } else {
    if (number > 0 && number < count.number) ++count.step;
    Object.assign(count, {number: number || count.number, seconds});
  }
  return count.step;
}

// What is left is said where the server knows it.
function left(job, title) {
  const step = stepOf(job);

  if (['add', 'preview'].includes(job.task)) return say('Everything is fitted again.');
  if (!job.detail) return '';
  const time = job.seconds >= 2 ? `, ${Math.round(job.seconds)} s` : '';
  if (triesPairs(job)) return say('All {0} have been tried alone; now those that may help together', job.of) + time;
  return (job.of > 0 && job.number <= job.of
    ? job.task === 'ladder'
      ? say('Step {0}: trying {1}, {2} of {3}', step, title(job.detail), job.number, job.of)
      : say('Trying {0}, {1} of {2}', title(job.detail), job.number, job.of)
    : say('Trying {0}', title(job.detail))) + time;
}

export function showDoing(job, title, adding) {
  if (!job) stopping = false;
  $('doing').hidden = !job;
  document.body.classList.toggle('busy', Boolean(job));
  if (!job) return;
  const halts = stopping || job.stopping;
  const box = $('doing');
  const put = (item, text) => {
    if (item.textContent !== text) item.textContent = text;
  };
  put(box.querySelector('h2'), halts ? say('Stopping…') : job.task === 'add' && adding
    ? say('Adding {0}…', adding) : translated(TASKS[job.task] ?? job.task) + '…');
  put(box.querySelector('p'), halts
    ? job.task === 'ladder' ? say('The step under way is left; those that are done stay.')
      : say('The part under way is left; then everything is as before.') : capital(left(job, title)));
  $('stop').disabled = halts;
  const bar = box.querySelector('progress');
  if (job.of > 0 && job.number <= job.of && ['explain', 'ladder'].includes(job.task) && !halts && !triesPairs(job)) {
    bar.max = job.of;
    bar.value = job.number - 1;
  } else {
    bar.removeAttribute('value');
  }
}

export function stop(job, title) {
  stopping = true;
  showDoing(job, title);
}
