// Times as the axes show them: clock time where the file has it, else time since the start.
import {language, say} from './texts.js';

export const unitFor = span =>
  span < 600 ? [1, 's'] : span < 6 * 3600 ? [60, 'min']
    : span < 4 * 86400 ? [3600, 'h'] : [86400, say('days')];

// Clock times as the file writes them: the zone is left out, so that nothing is shifted.
export const clockOf = start => start ? Date.parse(start.slice(0, 19) + 'Z') / 1000 : null;
const two = value => String(value).padStart(2, '0');
export function clockText(seconds, withSeconds) {
  const d = new Date(Math.round(seconds * 1000));
  return `${two(d.getUTCHours())}:${two(d.getUTCMinutes())}` +
    (withSeconds ? `:${two(d.getUTCSeconds())}` : '');
}
export const dayText = seconds => new Date(seconds * 1000)
  .toLocaleDateString(language, {day: 'numeric', month: 'short', timeZone: 'UTC'});
