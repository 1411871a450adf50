// A candidate before it is added: its curve over the model's, fit and errors beside it.
import {get, post} from './api.js';
import {parameterWords} from './direction.js';
import {$, button, capital, element, number, withUnitOf} from './dom.js';
import {say, translated} from './texts.js';

export class Preview {
  // add(codes, title) takes what is previewed into the model.
  constructor(charts, title, add) {
    Object.assign(this, {charts, title, add});
    this.shown = '';
  }

  async show(state) {
    const key = state.preview ? `${state.drawn} ${state.preview}` : '';
    const again = this.left && state.revision !== this.revision;
    if (key === this.shown && !again) return;
    Object.assign(this, {shown: key, left: false, revision: state.revision});
    if (!key) return this.drop();
    const seen = await get('/api/preview');
    const name = seen.previewed.map(this.title).join(say(' and '));
    this.charts.others('preview', [{label: say('with {0}', name), ink: 'truth', values: seen.simulated}]);
    this.draw(seen, name, state);
    $('preview').scrollIntoView({block: 'start'});
    $('preview').querySelector('button').focus({preventScroll: true});
  }

  drop() {
    this.charts.others('preview', []);
    $('preview').hidden = true;
    $('preview').replaceChildren();
  }

  draw(seen, name, {model: {output}, recording: {units}}) {
    const line = (label, key, digits) => element('tr', {}, element('td', {textContent: label}),
      ...[seen.before[key], seen[key]].map(value => element('td', {textContent: number(value, digits)})));
    const table = element('table', {}, element('thead', {}, element('tr', {}, element('th'),
      ...[say('the model'), say('with {0}', name)].map(textContent => element('th', {textContent})))),
    element('tbody', {}, line(say('Fit, %'), 'fit_percent', 4), line(withUnitOf(say('Error'), output, units), 'rmse', 4),
      line(withUnitOf(say('Validation error'), output, units), 'rmse_validation', 4)));
    const values = seen.effects.filter(term => seen.previewed.includes(term.effect))
      .flatMap(term => Object.values(term.parameters)).map(p => `${capital(parameterWords(p.words))}: ` +
        (p.choice ? translated(p.choice) : number(p.value, 4) + (p.unit_in_words && ' ' + p.unit_in_words)));
    const take = button(say('Put it into the model'), () => this.add(seen.previewed, name),
      {className: 'primary'});
    const drop = button(say('Leave it'), () => {
      this.drop();
      this.left = true;  // the same one may be asked for again
    });
    $('preview').replaceChildren(
      element('h3', {textContent: say('Preview: the model with {0}', name)}),
      element('div', {className: 'scroll'}, table),
      element('p', {className: 'fine', textContent: values.join(' · ')}),
      element('p', {className: 'choices'}, take, drop));
    $('preview').hidden = false;
  }
}

export const preview = ([effect, ...partners]) => post('/api/preview', {effect, with: partners});
