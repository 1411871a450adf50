// Whether a higher output opens the valve: the third question, and the words it changes.
import {say, translated} from './texts.js';

// "yes", "no", or "" where it is unknown; of the recording that is shown.
let answer = '';
export const opens = () => answer;
export const setOpens = now => { answer = now; };

export const ANSWERS = () => [['yes', say('yes')], ['no', say('no, it closes it')], ['', say('I do not know')]];

// Of the bands of the ascending stroke, with rising output, and of the descending one.
export const bandNames = () => ({
  '': [say('Stick band, ascending'), say('Stick band, descending')],
  yes: [say('Stick band, opening'), say('Stick band, closing')],
  no: [say('Stick band, closing'), say('Stick band, opening')],
})[opens()];

// The words of a parameter; a band or a jump of one stroke in those of the valve, where they are known.
export function parameterWords(words) {
  const [, what, stroke] = /^(stick band|slip jump) (ascending|descending)$/.exec(words) ?? [];
  if (!what || !opens()) return translated(words);
  const names = what === 'stick band' ? [say('stick band opening'), say('stick band closing')]
    : [say('slip jump opening'), say('slip jump closing')];
  return names[(stroke === 'ascending') === (opens() === 'yes') ? 0 : 1];
}

// A sentence of the verdict in the words of the valve, where they are known.
export function ofValve(sentence) {
  const rising = sentence === 'The valve sticks when the controller output rises, not when it falls.';
  const falling = sentence === 'The valve sticks when the controller output falls, not when it rises.';
  if (!opens() || !(rising || falling)) return null;
  return rising === (opens() === 'yes') ? say('The valve sticks when it opens, not when it closes.')
    : say('The valve sticks when it closes, not when it opens.');
}
