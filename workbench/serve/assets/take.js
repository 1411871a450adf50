// What the user takes along: session, model, signals, pictures, commands.
import {get} from './api.js';
import {$, element} from './dom.js';
import {say} from './texts.js';

function save(name, blob) {
  const link = element('a', {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const button = (text, onclick) => element('button', {type: 'button', textContent: text, onclick});
const link = (text, href) => element('a', {className: 'button', href, download: '', textContent: text});

export class Take {
  constructor(charts) {
    this.charts = charts;
    this.drawn = -1;
  }

  async show(state) {
    if (!state.model) return;
    if (this.drawn === state.drawn) return;
    this.drawn = state.drawn;
    const stem = state.recording.name.replace(/\.[^.]*$/, '');
    const {commands} = await get('/api/commands');
    const text = commands.join('\n');
    const copy = button(say('Copy'), async () => {
      try {
        await navigator.clipboard.writeText(text);
        copy.textContent = say('Copied');
      } catch {
        getSelection().selectAllChildren(lines);
        copy.textContent = say('Marked: copy with Ctrl-C');
      }
    });
    const lines = element('pre', {tabIndex: 0, role: 'region', ariaLabel: say('The same on the command line')},
      element('code', {textContent: text}));
    $('take').hidden = false;
    $('take').replaceChildren(
      element('h2', {textContent: say('Take it with you')}),
      element('p', {className: 'choices'},
        link(say('Save session'), '/api/session'),
        link(say('Save model'), '/api/model'),
        link(say('Signals as CSV'), '/api/csv'),
        button(say('Plots as PNG'), async () => save(`${stem}.png`, await this.charts.png())),
        button(say('Plots as SVG'), () => save(`${stem}.svg`,
          new Blob([this.charts.svg()], {type: 'image/svg+xml'})))),
      element('h3', {textContent: say('The same on the command line')}), lines, copy);
  }
}
