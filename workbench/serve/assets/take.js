// What the user takes along: session, model, signals, pictures, commands.
import {get, save} from './api.js';
import {$, button, element} from './dom.js';
import {say} from './texts.js';

export class Take {
  // saveFrom(path) saves a file of the server.
  constructor(charts, saveFrom) {
    Object.assign(this, {charts, saveFrom});
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
        ...[[say('Save session'), '/api/session'], [say('Save model'), '/api/model'],
          [say('Signals as CSV'), '/api/csv']].map(([text, path]) => button(text, () => this.saveFrom(path))),
        button(say('Plots as PNG'), async () => save(`${stem}.png`, await this.charts.png())),
        button(say('Plots as SVG'), () => save(`${stem}.svg`,
          new Blob([this.charts.svg()], {type: 'image/svg+xml'})))),
      element('h3', {textContent: say('The same on the command line')}), lines, copy);
  }
}
