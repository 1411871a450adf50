// What to beware of in a recording, kind by kind: how often, and where it is next.
import {$, button, element} from './dom.js';
import {say} from './texts.js';

const said = (kind, count) => ({
  limit: () => say('{0} × u at its limit', count),
  rest: () => say('{0} × u at rest (manual mode?)', count),
  step: () => say('{0} × a step of u', count),
  held: () => say('{0} × y held', count),
  straight: () => say('{0} × y on a straight line (compression?)', count),
  gap: () => say('{0} × a gap', count),
  manual: () => say('{0} × in manual', count),
})[kind]();

// leaveOut() fits without what is in manual; null where that cannot be.
export function showFacts(marks, charts, leaveOut) {
  const kinds = new Map();
  for (const [from, to, kind] of marks) {
    if (!kinds.has(kind)) kinds.set(kind, []);
    kinds.get(kind).push([from, to]);
  }
  const buttons = [...kinds].map(([kind, places]) => {
    let next = 0;
    const text = said(kind, places.length);
    return button(text, () => {
      const [from, to] = places[next++ % places.length];
      charts.lookAt(from, to);
    }, {className: 'small', ariaLabel: say('Show the next: {0}', text)});
  });
  if (kinds.has('manual') && leaveOut) {
    buttons.push(button(say('Leave out what is in manual'), leaveOut, {className: 'small'}));
  }
  $('facts').hidden = !buttons.length;
  $('facts').replaceChildren(...(buttons.length
    ? [element('span', {className: 'fine', textContent: say('In this recording:')}), ...buttons] : []));
}
