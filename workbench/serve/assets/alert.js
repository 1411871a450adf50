// What went wrong, in a box on top.
import {$, button, capital, element} from './dom.js';
import {say, translated} from './texts.js';

// What the page has where advice names options of the command line.
function advised(advice) {
  const period = /(, say --date-order.*)?, or give --ts SECONDS.*$/s;
  if (/^name the time column /.test(advice)) {
    return say('choose the time column, or give the sample period, under More options');
  }
  if (/ --decimal /.test(advice)) {
    return say('open it again with “let me choose the columns”, under More options');
  }
  if (/a model is given with --model/.test(advice)) {
    return say('a model or a session opens here as it was saved; else write CSV');
  }
  if (/^name .* --sheet/.test(advice)) return say('name the sheet, under More options');
  if (/^name the (columns?|tags?) .*--/.test(advice)) {
    return say('open it again with “let me choose the columns”, under More options');
  }
  if (period.test(advice)) {
    return translated(advice.replace(period, '')) + say(', or give the sample period under More options');
  }
  return translated(advice).replace(', --u-before', say(', under More options'));
}

const ended = text => /[.!?]$/.test(text) ? text : text + '.';

// `ofFile`: a file was not opened; what is shown is still the one before.
export function complain(error, heading = say('That did not work.'), ofFile = false) {
  const detail = error.error ?? {};
  const where = detail.line ? detail.file + ', ' + say('line {0}', detail.line) +
    (detail.column ? ', ' + say('column {0}', detail.column) : '') : detail.file;
  const parts = [element('h1', {textContent: heading})];
  if (detail.expected) {
    parts.push(element('p', {}, element('strong', {textContent: where + '. '}),
      say('Expected {0}; found {1}.', translated(detail.expected), translated(detail.found))));
    parts.push(element('p', {}, element('strong', {textContent: say('What to do.') + ' '}),
      ended(capital(advised(detail.advice)))));
  } else {
    parts.push(element('p', {textContent: capital(translated(error.message))}));
  }
  parts.push(button(say('Close'), silence));
  $('alert').replaceChildren(...parts);
  $('alert').classList.toggle('of-file', ofFile);
  $('alert').hidden = false;
  $('alert').scrollIntoView({block: 'nearest'});
}

export function silence() {
  $('alert').hidden = true;
}

// `keeps`: the page can bring back what it shows.
export const lost = keeps => complain(
  new Error((keeps ? say('It has ended, or was stopped. Start it again with {0} and come back to this page: without reloading, it can bring back what is shown.',
    `stickband serve --port ${location.port}`)
    : say('It has ended, or was stopped. Start it again with {0}, and reload this page.', `stickband serve --port ${location.port}`))),
  say('The program behind this page does not answer.'));
