// What went wrong, in a box on top.
import {$, capital, element} from './dom.js';
import {say, translated} from './texts.js';

export function complain(error, heading = say('That did not work.')) {
  const detail = error.error ?? {};
  const where = detail.line ? detail.file + ', ' + say('line {0}', detail.line) +
    (detail.column ? ', ' + say('column {0}', detail.column) : '') : detail.file;
  const parts = [element('h1', {textContent: heading})];
  if (detail.expected) {
    parts.push(element('p', {}, element('strong', {textContent: where + '. '}),
      say('Expected {0}; found {1}.', translated(detail.expected), translated(detail.found))));
    parts.push(element('p', {}, element('strong', {textContent: say('What to do.') + ' '}),
      capital(translated(detail.advice).replace('--ts SECONDS', say('the sample period below'))) + '.'));
  } else {
    parts.push(element('p', {textContent: capital(translated(error.message))}));
  }
  parts.push(element('button', {type: 'button', textContent: say('Close'), onclick: silence}));
  $('alert').replaceChildren(...parts);
  $('alert').hidden = false;
  $('alert').scrollIntoView({block: 'nearest'});
}

export function silence() {
  $('alert').hidden = true;
}

export const lost = () => complain(
  new Error(say('It has ended, or was stopped. Start stickband serve again and reload this page.')),
  say('The program behind this page does not answer.'));
