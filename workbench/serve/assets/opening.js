// Opening files: recordings, models, sessions; by button, by drop, or a simulated loop.
import {ApiError, get, post, withQuery} from './api.js';
import {Columns} from './columns.js';
import {$} from './dom.js';
import {say} from './texts.js';

const lacksTimes = ({error}) => /^a column t\b/.test(error?.expected ?? '');

export class Opening {
  // change(work, heading) runs what changes the recording; state() is the last one known.
  constructor({change, state, redraw}) {
    this.change = change;
    this.state = state;
    this.open = false;  // beside a recording
    this.columns = new Columns((file, query) => this.send(file, query, true));
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
      if (!this.open) return;
      $('open').scrollIntoView({block: 'nearest'});
      $('file').focus({preventScroll: true});
    };
    document.addEventListener('keydown', event => {
      if (event.key !== 'Escape' || !this.open) return;
      this.open = false;
      redraw();
      $('open-other').focus();
    });
  }

  show() {
    const {recording, model} = this.state();
    $('open').hidden = Boolean(recording) && !this.open;
    $('open-title').textContent = recording ? say('Open another recording')
      : say('Does your valve stick?');
    $('open-other').setAttribute('aria-expanded', String(this.open));
    $('keep-label').hidden = !model;
    $('earlier').textContent = recording
      ? say('Below is still {0}, the recording that was opened before.', recording.name) : '';
  }

  done(state) {
    this.open = false;
    $('keep').checked = false;
    $('ts').value = $('u-before').value = $('sheet').value = '';  // they were of that file
    this.columns.hide();
    return state;
  }

  take(file) {
    if (!file) return;
    this.columns.hide();
    const name = file.name;
    if (/\.json$/i.test(name)) {
      this.change(async () => {
        const session = /"kind":\s*"stickband-session"/.test(await file.slice(0, 200).text());
        return this.done(await post(withQuery(session ? '/api/session' : '/api/model', {name}), file));
      },
        say('{0} is no model and no session.', name), true);
      return;
    }
    const decimal = id => $(id).value.trim().replace(',', '.');
    const query = {u_before: decimal('u-before'), sheet: $('sheet').value.trim()};
    this.period = decimal('ts');
    if ($('choose').checked) {
      this.ask(file, query);
    } else {
      this.send(file, query);
    }
  }

  // Opens the file; where its columns are not clear, or were chosen, asks (again).
  send(file, query, chosen = false) {
    const {name} = file;
    const keep = !$('keep-label').hidden && $('keep').checked ? '1' : '';
    $('what').textContent = say('Opening {0}…', name);
    this.change(async () => {
      const open = more => post(withQuery('/api/recording',
        {name, keep, output: $('output').value, ...query, ...more}), file);
      try {
        return this.done(await open().catch(error => {
          if (!this.period || query.ts || !lacksTimes(error)) throw error;
          return open({ts: this.period});
        }));
      } catch (error) {
        if (!await this.asked(file, query, error, chosen)) throw error;
        return get('/api/state');
      }
    }, say('{0} cannot be used.', name), true);
  }

  ask(file, query, problem) {
    this.change(async () => {
      await this.columns.show(file, query, problem, this.period);
      return get('/api/state');
    }, say('{0} cannot be used.', file.name), true);
  }

  // Where the chooser can help: signals that are not clear, or dates with two readings.
  async asked(file, query, problem, chosen) {
    if (!(problem instanceof ApiError) || problem.status !== 400) return false;
    try {
      await this.columns.show(file, query, problem, this.period);
    } catch {
      return false;
    }
    // A cell that is no number is to be repaired, whichever columns are chosen, and a
    // recording too short is too short with all of them.
    const {columns} = this.columns.found, {expected} = problem.error;
    const helps = chosen || /^dates/.test(expected) ||
      columns.length > 1 && /^(a|one) (column|loop)/.test(expected);
    if (!helps) this.columns.hide();
    return helps;
  }
}
