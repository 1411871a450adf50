// Opening files: recordings, models, sessions; by button, by drop, or a simulated loop.
import {post, withQuery} from './api.js';
import {$} from './dom.js';
import {say} from './texts.js';

export class Opening {
  // change(work, heading) runs what changes the recording; state() is the last one known.
  constructor({change, state, redraw}) {
    this.change = change;
    this.state = state;
    this.open = false;  // beside a recording
    $('file').onchange = () => {
      this.take($('file').files[0]);
      $('file').value = '';
    };
    for (const type of ['dragenter', 'dragover']) {
      document.addEventListener(type, event => {
        event.preventDefault();
        document.body.classList.add('dropping');
      });
    }
    document.addEventListener('dragleave', event => {
      if (!event.relatedTarget) document.body.classList.remove('dropping');
    });
    document.addEventListener('drop', event => {
      event.preventDefault();
      document.body.classList.remove('dropping');
      this.take(event.dataTransfer.files[0]);
    });
    $('example').onclick = () => change(async () => this.done(await post('/api/example')));
    $('open-other').onclick = () => {
      this.open = !this.open;
      redraw();
      if (this.open) $('open').scrollIntoView({block: 'nearest'});
    };
  }

  show() {
    const {recording, model} = this.state();
    $('open').hidden = Boolean(recording) && !this.open;
    $('open-title').textContent = recording ? say('Open another recording')
      : say('Does your valve stick?');
    $('open-other').setAttribute('aria-expanded', String(this.open));
    $('keep-label').hidden = !model;
  }

  done(state) {
    this.open = false;
    $('keep').checked = false;
    return state;
  }

  take(file) {
    if (!file) return;
    const name = file.name;
    if (/\.json$/i.test(name)) {
      this.change(() => post(withQuery('/api/model', {name}), file),
        say('{0} cannot be used as a model.', name));
      return;
    }
    $('what').textContent = say('Opening {0}…', name);
    const keep = !$('keep-label').hidden && $('keep').checked ? '1' : '';
    this.change(async () => this.done(await post(withQuery('/api/recording', {name, keep,
      ts: $('ts').value.trim().replace(',', '.'), output: $('output').value}), file)),
    say('{0} cannot be used.', name));
  }
}
