// The server has another recording open than the one on the page, or was started anew: the
// page says so, keeps what it shows, and the user chooses. Its session, kept from time to
// time, brings the recording back with its models.
import {ApiError, getText, post, showsOpening, shownOpening, withQuery} from './api.js';
import {$, button, element} from './dom.js';
import {say} from './texts.js';

const MOST_CHARACTERS = 60e6;  // the server takes bodies of 64 MiB

export class Elsewhere {
  // act(work) runs what the user chooses.
  constructor(act) {
    this.act = act;
    this.kept = {};
    this.said = '';
  }

  // Whether `now` is no state of what is `shown`.
  tells(now, shown) {
    const here = shownOpening();
    if (!shown?.recording || here === now.opening) {
      showsOpening(now.opening);
      $('elsewhere').hidden = true;
      this.said = '';
      return false;
    }
    const said = `${now.begun} ${now.opening}`;
    if (said !== this.said) this.draw(now, shown.recording.name, now.begun > here);
    this.said = said;
    return true;
  }

  // Sees that what was refused is explained.
  point() {
    $('elsewhere').scrollIntoView({block: 'nearest'});
    $('elsewhere').querySelector('button').focus({preventScroll: true});
  }

  draw(now, name, anew) {
    const other = now.recording?.name;
    const buttons = [button(other ? say('Show {0}', other) : say('Begin anew'), () => location.reload())];
    const {text} = this.kept;
    if (text) {
      buttons.push(button(say('Bring {0} back with its models', name), () => this.act(async () => {
        await post(withQuery('/api/session', {name: 'session.json'}), text);
        location.reload();
        return new Promise(() => {});
      }), {className: anew ? 'primary' : ''}));
    }
    $('elsewhere').replaceChildren(
      element('h1', {textContent: anew
        ? say('The program behind this page was started anew.')
        : say('Another recording is open now: {0}.', other)}),
      element('p', {textContent: anew
        ? say('It knows nothing of {0}. Below is what was shown before; nothing can be changed or saved until you choose.', name)
        : say('It was opened in another tab or window; the program has one open at a time. Below is still {0}; nothing can be changed or saved until you choose.', name)}),
      element('p', {className: 'choices'}, ...anew ? buttons.reverse() : buttons));
    $('elsewhere').hidden = false;
    this.point();
  }

  // Keeps the session as it is now.
  async keep({revision, opening, model, job}) {
    const key = `${opening} ${revision}`;
    if (this.kept.opening !== opening) this.kept = {opening};
    if (!model || job || this.keeping || this.kept.key === key) return;
    this.keeping = true;
    try {
      const text = await getText('/api/session');
      this.kept = {opening, key, text: text.length < MOST_CHARACTERS ? text : ''};
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;  // the next look at the state will tell
    } finally {
      this.keeping = false;
    }
  }

  holds() {
    return Boolean(this.kept.text);
  }
}
