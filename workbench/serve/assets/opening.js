// Opening files: recordings, models, sessions; by button, by drop, or a simulated loop.
import {complain} from './alert.js';
import {ApiError, GivenUp, get, post, postForText, withQuery} from './api.js';
import {Columns} from './columns.js';
import {$, mayBeTwo, noNumber} from './dom.js';
import {say} from './texts.js';

export class Opening {
  // change(work, heading) runs what changes the recording, act(work, heading) what does not;
  // state() is the last one known.
  constructor({change, act, state, redraw}) {
    Object.assign(this, {change, act});
    this.state = state;
    this.open = false;  // beside a recording
    this.given = new AbortController();
    this.columns = new Columns((file, query) => this.columns.beside
      ? this.sendBeside(file, query, true) : this.send(file, query, true));
    $('file').onchange = () => {
      this.takeAll([...$('file').files]);
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
      this.takeAll([...event.dataTransfer.files]);
    });
    $('example').onclick = () => {
      const {turn, signal} = this.begin();
      change(async () => this.done(await post(withQuery('/api/example', {turn}), undefined, signal)));
    };
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
    for (const answer of document.querySelectorAll('[name=opens]')) answer.checked = false;
    this.columns.hide();
    return state;
  }

  // What is opened from now on: what was asked for before is given up.
  begin() {
    this.given.abort();
    this.given = new AbortController();
    return {turn: Date.now(), signal: this.given.signal};
  }

  // Several files at once are the signals of one loop, a file each.
  async takeAll(files) {
    if (files.length < 2) {
      if (files.length) this.take(files[0]);
      return;
    }
    const names = files.map(file => file.name), name = names.join(' + ');
    const {turn, signal} = this.begin();
    let table = null;
    await this.change(async () => {
      table = await postForText(withQuery('/api/table',
        {turn, names: names.join('\n'), sizes: files.map(file => file.size).join('\n')}), new Blob(files), signal);
      return get('/api/state');
    }, say('{0} cannot be used.', name), true);
    if (table !== null) this.take(new File([table], name));
  }

  async take(file) {
    this.columns.hide();
    const {name} = file;
    const [, kind] = /"kind":\s*"stickband[ -](model|session)"/.exec(await file.slice(0, 200).text().catch(() => '')) ?? [];
    if (kind || /\.json$/i.test(name)) {
      const {turn, signal} = this.begin();
      this.change(async () => {
        const session = kind === 'session';
        return this.done(await post(withQuery(session ? '/api/session' : '/api/model', {name, turn}), file, signal));
      },
        say('{0} is no model and no session.', name), true);
      return;
    }
    const unclear = ['ts', 'u-before'].map($).find(field => mayBeTwo(field.value));
    if (unclear) {
      const label = unclear.parentElement.querySelector('span').textContent.replace(/:$/, '');
      complain(new Error(noNumber(label, unclear.value)), say('{0} cannot be used.', name), true);
      return;
    }
    const decimal = id => $(id).value.trim().replace(',', '.');
    const query = {ts: decimal('ts'), u_before: decimal('u-before'), sheet: $('sheet').value.trim()};
    if ($('choose').checked) {
      this.ask(file, query);
    } else {
      this.send(file, query);
    }
  }

  // Opens the file; where its columns are not clear, or were chosen, asks (again).
  send(file, query, chosen = false) {
    const {name} = file;
    const opens = document.querySelector('[name=opens]:checked')?.value;
    const keep = !$('keep-label').hidden && $('keep').checked ? '1' : '';
    const {turn, signal} = this.begin();
    $('what').textContent = say('Opening {0}…', name);
    this.change(async () => {
      try {
        return this.done(await post(withQuery('/api/recording',
          {name, keep, output: $('output').value, opens, ...query, turn}), file, signal));
      } catch (error) {
        if (!await this.asked(file, query, error, chosen)) throw error;
        return get('/api/state');
      }
    }, say('{0} cannot be used.', name), true);
  }

  ask(file, query, problem) {
    const {turn} = this.begin();
    this.change(async () => {
      await this.columns.show(file, {...query, turn}, problem);
      return get('/api/state');
    }, say('{0} cannot be used.', file.name), true);
  }

  // A recording beside the one that is open: read like that one, or else its columns are
  // asked for.
  takeBeside(file) {
    this.columns.hide();
    this.sendBeside(file, {});
  }

  sendBeside(file, query, chosen = false) {
    const {name} = file;
    this.act(async () => {
      try {
        const state = await post(withQuery('/api/beside', {name, ...query}), file);
        if (chosen) {
          this.columns.hide();
          $('beside').scrollIntoView({block: 'start'});
        }
        return state;
      } catch (error) {
        if (!await this.asked(file, query, error, chosen, true)) throw error;
        return get('/api/state');
      }
    }, say('{0} cannot be used.', name));
  }

  // Where the chooser can help: signals that are not clear, or dates with two readings.
  async asked(file, query, problem, chosen, beside = false) {
    if (!(problem instanceof ApiError) || problem.status !== 400) return false;
    try {
      await this.columns.show(file, query, problem, beside);
    } catch (failure) {
      if (failure instanceof GivenUp) throw failure;
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
