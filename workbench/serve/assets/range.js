// Choosing the data: what is seen in the charts is fitted or judged alone, or left out.
import {post} from './api.js';
import {$, button, element} from './dom.js';
import {say} from './texts.js';

const small = (text, onclick) => button(text, onclick, {className: 'small'});

export class Range {
  constructor(charts, change) {
    Object.assign(this, {charts, change});
    charts.onRange = (range, all) => {
      this.range = all ? null : range;
      this.draw();
    };
  }

  show(state) {
    if (state.opened !== this.state?.opened) this.range = null;
    this.state = state;
    this.draw();
  }

  draw() {
    if (!this.state?.recording) return;
    const items = [], {model, job, is_range: part, left_out: without, beside_fitted} = this.state;
    if (beside_fitted.includes(true)) {
      this.drawn = null;
      $('range').hidden = true;  // a range is one of a single recording
      return;
    }
    const ask = (what, range) => () => this.change(() => post('/api/range',
      range ? {what, from: range[0], to: range[1]} : {what}));
    if (this.range) {
      const [from, to] = this.range;
      items.push(element('span', {textContent: say('What is seen:')}));
      if (!part) {
        items.push(small(say('Judge and fit it alone'), ask('fit', this.range)));
        if (model) items.push(small(say('Judge this model on it'), ask('judge', this.range)));
      }
      items.push(small(say('Leave it out'), () => this.change(async () => {
        const state = await post('/api/leave_out', {from, to});
        this.charts.zoom('all');
        return state;
      })));
    }
    if (part) {
      items.push(element('span', {textContent: say('A range of the recording is open.')}),
        small(say('Open all of it'), ask('fit')));
      if (model) items.push(small(say('Judge this model on all of it'), ask('judge')));
    }
    if (without) {
      items.push(element('span', {textContent: say('Grey stretches are left out.')}),
        small(say('Take them in again'), () => this.change(() => post('/api/leave_out', {}))));
    }
    const key = [...items.map(item => item.textContent), Boolean(job), ...this.range ?? []].join();
    if (key === this.drawn) return;
    this.drawn = key;
    for (const item of items) if (item.localName === 'button') item.disabled = Boolean(job);
    const focused = $('range').contains(document.activeElement) && document.activeElement.textContent;
    $('range').replaceChildren(...items);
    $('range').hidden = !items.length;
    items.find(item => item.textContent === focused)?.focus();
  }
}
