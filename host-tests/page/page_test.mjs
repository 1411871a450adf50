// The way of a user through the page, in a browser: page_test.mjs [TEST...].
import {copyFileSync, readFileSync} from 'node:fs';
import {check, close, end, faults, forget, idle, killAll, look, path, serve, shot, sound, told, until} from './served.mjs';
import {counted, inManual, loaded, loopAlone, loopInParts, longRecording, loops, many, onOneStroke, renamed, stepped, wideExport} from './files.mjs';

// Presses Stop; milliseconds until nothing is under way. With a text: in the tick in which
// something was added and the page says that it does what the text says, however short.
const stopped = async (page, doing = '') => {
  const idle = await page.waitForFunction(doing => {
    const box = document.getElementById('doing');
    if (doing && (box.hidden || document.getElementById('added').hidden ||
        !document.querySelector('#doing h2').textContent.includes(doing))) return null;
    return new Promise(done => {
      const began = performance.now();
      const look = () => { if (box.hidden) done({after: Math.round(performance.now() - began)}); };
      new MutationObserver(look).observe(box, {attributes: true});
      document.getElementById('stop').click();
      look();
    });
  }, doing, {polling: 20});
  return (await idle.jsonValue()).after;
};

const tests = {
  // From an export with two loops to a saved report, with the mouse.
  async mouse() {
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await sound(page, 'start');
    await shot(page, 'start-1400-light');
    await page.setInputFiles('#file', wideExport());
    await page.waitForSelector('#columns:not([hidden]) li');
    check(await page.locator('#columns li').count() === 5, 'five signals to choose from');
    check(await page.locator('#columns .loops button').allInnerTexts().then(String) === 'FIC101,TIC205',
      'both loops are offered');
    await sound(page, 'columns');
    await shot(page, 'columns-1400-light');
    const choose = (signal, role) =>
      page.selectOption(`select[data-signal^="${signal}"]`, role);
    await choose('FIC101.OP', 'u');
    await choose('FIC101.PV', 'y');
    await choose('TIC205.PV', 'load');
    await page.getByRole('button', {name: 'Use these columns'}).click();
    await page.waitForSelector('#valve.bad');
    // The first screen: verdict, band with interval, what to do, pictures.
    const seen = await page.locator('#valve').innerText();
    for (const part of ['The valve sticks.', 'Stick band', '95 %', 'What to do.']) {
      check(seen.includes(part), 'the first screen lacks', part);
    }
    const box = await page.locator('#valve').boundingBox();
    check(box.y + box.height < 900, 'the verdict fits the first screen');
    check(await page.locator('#valve svg[role=img]').count() === 2, 'two pictures');
    await shot(page, 'verdict-1400-light');
    await idle(page);
    check((await page.locator('#verdict').innerText()).includes('The model still lacks stiction'));
    check((await page.locator('#candidates').textContent()).includes('disturbance.measured:TIC205.PV'), 'the load is tried');
    check(await page.locator('#valve.bad').count() === 1, 'the verdict stays');
    await page.getByRole('button', {name: /^Put stiction .*into the model/}).first().click();
    await page.waitForSelector('#added:not([hidden])');
    await idle(page);
    check(await page.locator('#valve.bad').count() === 1, 'the verdict stays in its colour');
    check((await page.locator('#valve h1').innerText()) === 'The valve sticks.');
    await sound(page, 'explained');
    await shot(page, 'explained-1400-light', true);
    await page.getByRole('button', {name: 'Take out: stiction'}).click();
    await page.waitForFunction(() => document.getElementById('added').textContent.includes('taken out'));
    await idle(page);
    check((await page.locator('#verdict').innerText()).includes('The model still lacks stiction'), 'taken out');
    await page.getByRole('button', {name: 'Undo'}).click();
    await page.waitForFunction(() => !document.getElementById('redo').disabled);
    await page.getByRole('button', {name: 'Redo'}).click();
    await page.waitForFunction(() => document.getElementById('redo').disabled);
    await page.getByRole('button', {name: 'Undo'}).click();
    await page.waitForFunction(() => !document.getElementById('redo').disabled);
    const download = page.waitForEvent('download');
    await page.getByRole('button', {name: 'Save report'}).click();
    const report = readFileSync(await (await download).path(), 'utf8');
    check(report.indexOf('The valve sticks.') < report.indexOf('The model'), 'the verdict first');
    const paper = await page.context().newPage();
    await paper.setContent(report);
    const pdf = (await paper.pdf({format: 'A4'})).toString('latin1');
    check(pdf.match(/\/Type\s*\/Page[^s]/g).length <= 2, 'the report prints on two pages');
    await end(page);
    served.end();
  },

  // The same with the keyboard alone, narrow and dark.
  async keyboard() {
    const served = await serve();
    const page = await look(served.address, {width: 390, scheme: 'dark'});
    await page.waitForSelector('#open:not([hidden])');
    await sound(page, 'start, narrow');
    await shot(page, 'start-390-dark');
    const reach = async (wanted, most = 60) => {
      for (let i = 0; i < most; ++i) {
        await page.keyboard.press('Tab');
        if (await page.evaluate(selector => document.activeElement?.matches(selector), wanted)) return;
      }
      throw new Error(`the keyboard does not reach ${wanted}`);
    };
    // A browser on a busy machine may let the dialogue of a key press go.
    let chooser = null;
    for (let i = 0; i < 3 && !chooser; ++i) {
      await reach('#file');
      const opened = page.waitForEvent('filechooser', {timeout: 20000}).catch(() => null);
      await page.keyboard.press('Space');
      chooser = await opened;
    }
    check(chooser, 'Space on the file opens the dialogue');
    await chooser.setFiles(wideExport());
    await page.waitForSelector('#columns:not([hidden]) li');
    await sound(page, 'columns, narrow');
    await shot(page, 'columns-390-dark');
    for (const [signal, letter] of [['FIC101.OP', 'u'], ['FIC101.PV', 'y']]) {
      await reach(`select[data-signal^="${signal}"]`);
      await page.keyboard.type(letter);
    }
    const use = await page.locator('#columns .primary').boundingBox();
    check(use.y + use.height <= 900, 'the button that opens is on the screen, found at', use.y);
    await reach('#columns .primary');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#valve.bad');
    await page.evaluate(() => scrollTo(0, 0));
    const picture = await page.locator('#valve svg[role=img]').first().boundingBox();
    check(picture.y < 900 && (await page.locator('.todo').boundingBox()).y < picture.y,
      'verdict, band, what to do and the picture begin on the first screen');
    await shot(page, 'verdict-390-dark');
    await idle(page);
    const primary = await page.locator('#verdict .choices .primary').boundingBox();
    check(primary.y + primary.height <= 900, 'the main button is on the first screen, found at', primary.y);
    await shot(page, 'lacks-390-dark');
    await reach('#verdict .choices .primary');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#added:not([hidden])');
    await idle(page);
    await sound(page, 'explained, narrow');
    await shot(page, 'explained-390-dark', true);
    await reach('#charts');
    await page.keyboard.press('+');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('0');
    await page.keyboard.press('Control+Home');
    await page.evaluate(() => document.activeElement.blur());
    await reach('#save-report', 200);
    const download = page.waitForEvent('download');
    await page.keyboard.press('Enter');
    check((await (await download).suggestedFilename()).endsWith('.report.html'));
    await end(page);
    served.end();
  },

  // Stop: what stood there comes back; another tab sees the work.
  async stop() {
    // Long enough that the work outlasts the opening of another tab.
    const served = await serve(longRecording(30000));
    const page = await look(served.address);
    await idle(page);
    const before = await page.locator('#verdict').innerText();
    await page.getByRole('button', {name: 'Do all steps'}).click();
    const other = await look(served.address, {scheme: 'dark'});
    await other.waitForSelector('#doing:not([hidden])');
    check((await other.locator('#doing h2').innerText()).includes('step by step'));
    await page.evaluate(() => {
      document.getElementById('stop').addEventListener('click', () =>
        requestAnimationFrame(() => { window.said = document.querySelector('#doing h2').textContent; }),
      {once: true});
    });
    console.log(`  Stop of the ladder to idle: ${await stopped(page)} ms`);
    check(await page.evaluate(() => window.said) === 'Stopping…' ||
      await page.locator('#doing').isHidden(), 'says that it stops');
    check((await page.locator('#verdict').innerText()) === before, 'the state before is back');
    await other.waitForSelector('#doing', {state: 'hidden'});
    check((await served.api('state')).can_undo === false, 'nothing was added');
    // A search that is over before its Stop arrives is asked for once more.
    for (let tries = 0; tries < 3; ++tries) {
      const over = told(page, state => state.can_undo).then(() => null, () => null);
      const searching = stopped(page, 'missing').catch(() => null);
      await page.getByRole('button', {name: /^Put stiction .*into the model/}).first().click();
      const after = await Promise.race([searching, over]);
      console.log(`  Stop of the search to idle: ${after} ms`);
      if (after !== null) break;
      await page.getByRole('button', {name: 'Undo'}).click();
      await page.waitForFunction(() => !document.getElementById('redo').disabled);
      await idle(page);
    }
    await page.waitForSelector('#verdict .not-explained');
    await other.waitForSelector('#verdict .not-explained');
    check((await served.api('state')).job === null, 'no other tab begins it again');
    await end(other);
    await end(page);
    served.end();
  },

  // All steps: each is in the chart as soon as it is done, stays when the rest is stopped,
  // and Undo takes back one.
  async climb() {
    const served = await serve(loaded());
    const page = await look(served.address);
    await idle(page);
    const points = () => page.locator('#ladder circle.two-path').count();
    await page.getByRole('button', {name: 'Do all steps'}).click();
    await page.waitForFunction(() => !document.getElementById('doing').hidden &&
      document.querySelectorAll('#ladder circle.two-path').length > 1);
    await shot(page, 'climb-1400-light');
    await stopped(page);
    await page.waitForSelector('#verdict .not-explained');
    // Effects that were found together, and one that went again, are points of one model.
    const steps = async () => (await served.api('model')).history.length;
    check(await steps() > 1 && await steps() === await points(), 'the steps that were done stay');
    // What Undo brings back is still drawn when the ladder is asked for, and is no step of it.
    for (const [slow, ms] of [['models', 500], ['ladder', 2000]]) {
      await page.route(`**/api/${slow}`, route => setTimeout(() => route.continue(), ms));
    }
    const count = async () => (await served.api('models')).models.length;
    for (let left = await count(); left > 1; left -= 1) {
      await page.getByRole('button', {name: 'Undo'}).click();
      while (await count() === left) await page.waitForTimeout(50);
    }
    await page.waitForFunction(() => document.getElementById('undo').disabled);
    await page.getByRole('button', {name: 'Do all steps'}).click();
    await page.waitForSelector('#added:text("Undo takes back one")');
    const models = await count();
    check(models > 2 && await steps() === await points(), models, 'models', await points(), 'points');
    await page.getByRole('button', {name: 'Undo'}).click();
    await until(page, async () => (await (await fetch('/api/models')).json()).models.length > 1);
    check(await count() === models - 1, 'one step back');
    await end(page);
    served.end();
  },

  // The sample period typed takes the place of the times, and is that of no other file.
  async period() {
    wideExport();
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await page.locator('#more-options summary').click();
    await page.locator('#ts').fill('abc');
    await page.setInputFiles('#file', counted());
    await page.waitForSelector('#alert :text("a positive number of seconds as the sample period")');
    await page.locator('#ts').fill('1,000');
    await page.setInputFiles('#file', counted());
    await page.waitForSelector('#alert :text("is no number, or may be two")');
    await page.locator('#ts').fill('5');
    await page.setInputFiles('#file', loopAlone());
    await page.waitForSelector('#what:text("one every 5 s")');
    await page.getByRole('button', {name: 'Open another…'}).click();
    check(await page.locator('#ts').inputValue() === '', 'cleared');
    await page.locator('#ts').fill('5');
    await page.setInputFiles('#file', counted());
    await page.waitForSelector('#what:text("one every 5 s")');
    await end(page);
    served.end();
  },

  // A column of times that names no unit.
  async unit() {
    wideExport();
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await page.setInputFiles('#file', counted('Ticks', 250));
    await page.waitForSelector('#columns :text("one every 250 s")');
    await page.getByRole('combobox', {name: 'counted in'}).selectOption('ms');
    await page.waitForSelector('#columns :text("one every 0.25 s")');
    await sound(page, 'unit');
    await shot(page, 'unit-1400-light');
    await page.getByRole('button', {name: 'Use these columns'}).click();
    await page.waitForSelector('#what:text("one every 0.25 s")');
    await end(page);
    served.end();
  },

  // The file asked for last stays, however long the one before it, or its error, takes.
  async overtaken() {
    wideExport();
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    for (const long of [many('many.csv'), many('torn.csv', 'torn')]) {
      if (await page.locator('#open').isHidden()) await page.locator('#open-other').click();
      await page.setInputFiles('#file', long);
      await page.waitForTimeout(150);
      await page.setInputFiles('#file', loopAlone());
      await page.waitForSelector('#what:text("alone.csv ·")');
      await page.waitForTimeout(4000);
      check((await page.locator('#what').innerText()).startsWith('alone.csv'), 'the last one is open');
      check((await served.api('state')).recording.name === 'alone.csv', 'in the program, too');
      check(await page.locator('#alert').isHidden() && await page.locator('#elsewhere').isHidden(), 'and nothing is said of', long);
    }
    await end(page);
    served.end();
  },

  // A file that cannot be opened leaves what was open, and the page says so.
  async earlier() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address, {width: 390});
    await idle(page);
    const model = (await served.api('state')).model;
    check(await page.locator('#earlier').isHidden(), 'what is open is current');
    await page.getByRole('button', {name: 'Open another…'}).focus();
    await page.keyboard.press('Enter');
    check(await page.evaluate(() => document.activeElement.id) === 'file', 'the focus goes along');
    await page.keyboard.press('Escape');
    check(await page.locator('#open').isHidden(), 'Escape closes it');
    await page.setInputFiles('#file', wideExport('again.csv'));
    await page.waitForSelector('#columns:not([hidden]) li');
    await page.waitForSelector('#earlier:text("historian.csv"):visible');
    const cancel = page.getByRole('button', {name: 'Cancel'});
    await cancel.scrollIntoViewIfNeeded();
    const hit = await cancel.evaluate(button => {
      const {x, y, width, height} = button.getBoundingClientRect();
      return document.elementFromPoint(x + width / 2, y + height / 2) === button;
    });
    check(hit, 'nothing lies over the buttons of the chooser');
    await sound(page, 'earlier');
    await shot(page, 'earlier-390-light');
    await page.setInputFiles('#file', {name: 'loop.parquet', mimeType: 'text/plain', buffer: Buffer.from('PAR1')});
    await page.waitForSelector('#alert:not([hidden])');
    check(await page.locator('#columns').isHidden(), 'the chooser of the file before is gone');
    check(await page.locator('#earlier').isVisible(), 'named under an error');
    await page.getByRole('button', {name: 'Close', exact: true}).first().click();
    check(await page.locator('#earlier').isHidden(), 'and not after it');
    check(JSON.stringify((await served.api('state')).model) === JSON.stringify(model), 'the model is as it was');
    // Where a file is not understood the page names none of the options of the command line.
    await page.setInputFiles('#file', {name: 'lines.txt', mimeType: 'text/plain', buffer: Buffer.from(
      Array.from({length: 9}, (_, k) => `FIC101 unit=A OP=0.${k} PV=-0.4 at 177868260${k}`).join('\n'))});
    await page.waitForSelector('#columns :text("fewer than two signals")');
    check(!/--\w/.test(await page.locator('#columns').innerText()), 'no options of the command line');
    await end(page);
    served.end();
  },

  // Every reload is whole; a model opens while a search is under way, a session whatever its
  // name is.
  async opened() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    for (let i = 0; i < 10; ++i) {
      await page.reload();
      await page.waitForFunction(() => document.querySelector('#language').options.length > 1);
    }
    check(await page.locator('#unloaded').count() === 0, 'no complaint of a page that is whole');
    await idle(page);
    const model = await (await fetch(served.address + 'api/model')).text();
    await fetch(served.address + 'api/explain', {method: 'POST'});
    await page.setInputFiles('#file', {name: 'm3.json', mimeType: 'application/json', buffer: Buffer.from(model)});
    await until(page, async () => (await (await fetch('/api/models')).json()).models.length > 1);
    check(await page.locator('#alert').isHidden(), 'a model is taken while a search is under way');
    await idle(page);
    const session = await (await fetch(served.address + 'api/session')).text();
    const {opened} = await (await fetch(served.address + 'api/state')).json();
    await page.setInputFiles('#file', {name: 'saved', mimeType: '', buffer: Buffer.from(session)});
    await page.waitForFunction(async before => (await (await fetch('/api/state')).json()).opened > before, opened);
    await idle(page);
    check(await page.locator('#alert').isHidden(), 'a session without .json opens');
    await end(page);
    served.end();
  },

  // A loop whose u rests is listed, but cannot be opened; an error leaves the chooser open.
  async chooser() {
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await page.setInputFiles('#file', wideExport('resting.csv', true));
    await page.waitForSelector('#columns:not([hidden]) .loops');
    check(await page.getByRole('button', {name: 'TIC205: u does not move'}).isDisabled(), 'told as not usable');
    await page.selectOption('select[data-signal^="FIC101.OP"]', 'u');
    await page.selectOption('select[data-signal^="TIC205.OP"]', 'u');
    check(/TIC205.OP.* is u now; FIC101.OP.* was/.test(await page.locator('#columns-why').innerText()), 'told that u is another');
    await page.selectOption('select[data-signal^="TIC205.PV"]', 'y');
    await page.getByRole('button', {name: 'Use these columns'}).click();
    await page.waitForSelector('#columns .problem:text("found a constant u")');
    await sound(page, 'chooser');
    await shot(page, 'chooser-1400-light', true);
    await page.getByRole('button', {name: 'FIC101'}).click();
    await page.waitForSelector('#valve.bad');
    await end(page);
    served.end();
  },

  // The newest of many steps is seen.
  async history() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const fitted = await look(served.address);
    await idle(fitted);
    await end(fitted);
    const model = await served.api('model');
    model.history = Array(12).fill(model.history[0]);
    await fetch(served.address + 'api/model?name=m.json', {method: 'POST', body: JSON.stringify(model)});
    for (const width of [1400, 390]) {
      const page = await look(served.address, {width});
      await page.waitForFunction(() => document.querySelectorAll('#ladder circle.two-path').length === 12);
      const [newest, frame] = await page.evaluate(() => [...document.querySelectorAll('#ladder circle.two-path')]
        .slice(-1).concat(document.querySelector('#ladder .plot')).map(item => item.getBoundingClientRect().right));
      check(newest < frame, width, 'px: the newest step at', newest, 'beyond', frame);
      await shot(page, `history-${width}`);
      await end(page);
    }
    served.end();
  },

  // The program ends while the page is open.
  async killed() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await page.waitForSelector('#charts canvas');
    served.end();
    await page.waitForSelector('#alert:not([hidden])');
    check((await page.locator('#alert').innerText()).includes('does not answer'));
    await sound(page, 'killed');
    await end(page);
  },

  // Two tabs of one program: what one shows is not changed or saved as another recording.
  async tabs() {
    const served = await serve();
    const [first, second] = [await look(served.address), await look(served.address)];
    await first.waitForSelector('#open:not([hidden])');
    await first.setInputFiles('#file', onOneStroke());
    await idle(first);
    await second.waitForSelector('#work:not([hidden])');
    await idle(second);
    await second.getByRole('button', {name: 'Open another…'}).click();
    await second.setInputFiles('#file', wideExport());
    await second.locator('#columns .loops button').first().click();
    // At once, before the first tab looks again.
    await second.waitForFunction(() => document.getElementById('what').textContent.startsWith('historian.csv'));
    const before = await served.api('state');
    check(before.recording.name !== 'one-stroke.csv', 'another is open:', before.recording.name);
    await first.getByRole('button', {name: 'Save report'}).click();
    await first.waitForSelector('#elsewhere:not([hidden])');
    check((await first.locator('#elsewhere').innerText()).includes('Another recording is open now: historian.csv.'));
    check((await first.locator('#what').innerText()).startsWith('one-stroke.csv'), 'it shows what it showed');
    await first.getByRole('button', {name: /^Put .* into the model/}).first().click();
    await idle(second);
    check((await served.api('state')).model.effects.length === 0, 'the other model is as it was');
    await sound(first, 'another is open');
    await shot(first, 'tabs-1400-light');
    // Each way out.
    await first.getByRole('button', {name: 'Bring one-stroke.csv back with its models'}).click();
    await first.waitForFunction(() => document.getElementById('elsewhere').hidden &&
      document.getElementById('what').textContent.startsWith('one-stroke.csv'));
    await second.waitForSelector('#elsewhere:not([hidden])');
    await second.getByRole('button', {name: 'Show one-stroke.csv'}).click();
    await second.waitForFunction(() => document.getElementById('what').textContent.startsWith('one-stroke.csv'));
    await end(first);
    await end(second);
    served.end();
  },

  // The program is started anew: the page keeps what it shows and brings it back.
  async restarted() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await idle(page);
    await page.getByRole('button', {name: /^Put stiction .*into the model/}).first().click();
    await page.waitForSelector('#added:not([hidden])');
    await idle(page);
    await page.waitForTimeout(1000);
    served.end();
    await page.waitForSelector('#alert:not([hidden])');
    check((await page.locator('#alert').innerText()).includes('it can bring back what is shown'));
    const again = await serve('--port', new URL(served.address).port);
    await page.waitForSelector('#elsewhere:not([hidden])');
    check((await page.locator('#elsewhere').innerText()).includes('was started anew'));
    check(await page.locator('#alert').isHidden(), 'it answers again');
    check((await page.locator('#what').innerText()).startsWith('historian.csv'), 'it shows what it showed');
    await page.getByRole('button', {name: 'Undo'}).click();
    check(await page.locator('#elsewhere').isVisible(), 'and nothing else');
    await sound(page, 'started anew');
    await shot(page, 'restarted-1400-light');
    await page.getByRole('button', {name: 'Bring historian.csv back with its models'}).click();
    await page.waitForFunction(() => document.getElementById('elsewhere').hidden);
    await idle(page);
    const state = await again.api('state');
    check(state.model.effects.includes('valve.stiction') && state.can_undo, 'the models are back:', state.model.effects);
    await end(page);
    again.end();
  },

  // 100,000 rows: the plot, the zoom, the verdict.
  async long() {
    const file = longRecording();
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    const began = Date.now();
    await page.setInputFiles('#file', file);
    await page.waitForSelector('#charts canvas');
    console.log(`  100,000 rows, first plot: ${Date.now() - began} ms`);
    await page.waitForSelector('#valve.bad');
    console.log(`  first verdict: ${Date.now() - began} ms`);
    const [script, zoom] = await page.evaluate(async () => {
      const script = [], times = [];
      for (const what of ['in', 'in', 'right', 'in', 'out', 'all', 'in', 'in', 'in', 'in', 'in', 'in', 'out', 'all', 'in']) {
        const start = performance.now();
        document.querySelector(`[data-zoom=${what}]`).click();
        await Promise.resolve().then(() => {});  // the plots draw in a microtask
        script.push(performance.now() - start);
        await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
        times.push(performance.now() - start);
      }
      const rising = values => values.sort((a, b) => a - b);
      return [rising(script), rising(times)];
    });
    console.log(`  zoom, script: median ${script[7].toFixed(0)} ms, longest ${script[14].toFixed(0)} ms`);
    console.log(`  zoom to next frame, drawn by software: median ${zoom[7].toFixed(0)} ms, longest ${zoom[14].toFixed(0)} ms`);
    await shot(page, 'long-1400-light');
    await page.waitForFunction(() => !document.querySelector('#valve .so-far:not([hidden])'),
      null, {timeout: 120000});
    console.log(`  verdict of all parts: ${Date.now() - began} ms`);
    await page.waitForSelector('#doing:not([hidden])');
    for (const [what, after] of [['search', 1500], ['ladder', 3000]]) {
      if (what === 'ladder') {
        await page.getByRole('button', {name: 'Do all steps'}).click();
        await page.waitForSelector('#doing:not([hidden])');
      }
      await page.waitForTimeout(after);
      console.log(`  Stop of the ${what} to idle: ${await stopped(page)} ms`);
    }
    await end(page);
    served.end();
  },

  // Parameters by slider, models side by side, a range, and what is taken along.
  async play() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await page.waitForSelector('#valve.bad');
    await idle(page);
    await page.locator('#play summary').click();
    const slider = page.getByRole('slider', {name: 'process: gain'});
    const times = [];
    await slider.focus();
    for (let i = 0; i < 12; ++i) {
      await page.evaluate(() => { delete document.getElementById('play').dataset.milliseconds; });
      await page.keyboard.press('ArrowRight');
      await page.waitForFunction(() => document.getElementById('play').dataset.milliseconds);
      times.push(Number(await page.locator('#play').getAttribute('data-milliseconds')));
    }
    times.sort((a, b) => a - b);
    console.log(`  slider to new curve, 2,900 samples: median ${times[6]} ms, longest ${times[11]} ms`);
    check((await page.locator('.tried').innerText()).includes('(the model:'), 'says what it was');
    const field = page.getByRole('textbox', {name: 'process: first lag, as a number'});
    const keep = page.getByRole('button', {name: 'Keep these values'}), lag = await field.inputValue();
    for (const [text, part] of [['abc', 'no number'], ['1,000', 'may be two'], ['-5', 'found −5'], ['1e300', 'expected']]) {
      await field.fill(text);
      await field.blur();
      check((await page.locator('.refused').innerText()).includes(part), text, 'is refused');
      check(await field.getAttribute('aria-invalid') === 'true' && await keep.isDisabled(), text, 'is marked');
    }
    await field.fill(lag);
    await field.blur();
    check(await page.locator('.refused').isHidden() && await keep.isEnabled(), 'a number within its bounds is taken');
    await page.locator('#scatter summary').click();
    await page.waitForFunction(() => document.querySelectorAll('#scatter svg').length === 4);
    await sound(page, 'play');
    await page.getByRole('button', {name: 'Keep these values'}).click();
    await page.waitForSelector('#compare:not([hidden]) table');
    await page.locator('#compare input[data-model="0"]').check();
    await page.waitForFunction(() => document.querySelectorAll('#charts .u-series:not(.edge)').length >= 8);
    await sound(page, 'compare');
    await shot(page, 'play-1400-light', true);
    const saved = {};
    for (const [role, name, what] of [['button', 'Save session', 'session'], ['button', 'Signals as CSV', 'csv'],
      ['button', 'Plots as PNG', 'png'], ['button', 'Plots as SVG', 'svg']]) {
      const download = page.waitForEvent('download');
      await page.getByRole(role, {name}).click();
      saved[what] = await (await download).path();
    }
    check(readFileSync(saved.csv, 'utf8').startsWith('t,u,y,sp,simulated,residual\n'), 'signals');
    check(readFileSync(saved.png).subarray(1, 4).toString() === 'PNG', 'a PNG');
    check(readFileSync(saved.svg, 'utf8').startsWith('<svg xmlns="http://www.w3.org/2000/svg"'), 'an SVG');
    check((await page.locator('#take pre').innerText()).includes('stickband identify'), 'commands');
    await page.getByRole('button', {name: 'Zoom in'}).click();
    await page.getByRole('button', {name: 'Judge this model on it'}).click();
    await page.waitForSelector('#range :text("A range of the recording is open.")');
    check((await served.api('state')).recording.samples < 1500, 'half of it is open');
    copyFileSync(saved.session, path('saved.session.json'));
    await page.getByRole('button', {name: 'Open another…'}).click();
    await page.setInputFiles('#file', path('saved.session.json'));
    await page.waitForFunction(() => document.getElementById('what').textContent.includes('2900'));
    check((await served.api('models')).models.length === 2, 'both models are back');
    await end(page);
    served.end();
  },

  // Choosing the data: a stretch left out, the samples shared out, what to beware of.
  async choose() {
    const served = await serve(stepped(), '--u', 'OP', '--y', 'PV');
    const page = await look(served.address);
    await page.waitForSelector('#valve h1:not(.waits)');
    await idle(page);
    const facts = await page.locator('#facts').innerText();
    for (const part of ['× a gap', '× a step of u', '× u at rest']) {
      check(facts.includes(part), 'what to beware of lacks', part, 'in', facts);
    }
    await page.getByRole('button', {name: /Show the next: .* a gap/}).click();
    await page.getByRole('button', {name: 'Leave it out'}).click();
    await page.waitForSelector('#range :text("Grey stretches are left out.")');
    await page.waitForFunction(() => document.getElementById('doing').hidden);
    const state = await served.api('state');
    check(state.left_out, 'the gap is left out');
    check((await served.api('signals')).left_out.length === 1);
    await page.locator('#split summary').click();
    await page.locator('#split select').selectOption('70');
    await page.locator('#split input').fill('200');
    const fitted = told(page, now => now.split.estimation_share === 0.7);
    await page.getByRole('button', {name: 'Fit with it'}).click();
    await fitted;
    await idle(page);
    await page.waitForSelector('#split details[open]');
    await sound(page, 'choose');
    await page.locator('#charts').scrollIntoViewIfNeeded();
    await shot(page, 'choose-1400-light');
    // With the keyboard: zoom, leave out, take in again.
    await page.locator('#charts').focus();
    for (const key of ['0', '+', '+']) await page.keyboard.press(key);  // clear of the gap
    const out = page.getByRole('button', {name: 'Leave it out'});
    const {opened} = await served.api('state');
    await page.waitForFunction(() => [...document.querySelectorAll('#range button')].every(b => !b.disabled));
    const less = told(page, now => now.opened > opened);
    await out.focus();
    await page.keyboard.press('Enter');
    await less;
    await idle(page);
    check((await served.api('signals')).left_out.length === 2, 'two stretches are left out');
    await page.waitForFunction(() => [...document.querySelectorAll('#range button')].every(b => !b.disabled));
    const whole = told(page, now => !now.left_out);
    await page.getByRole('button', {name: 'Take them in again'}).focus();
    await page.keyboard.press('Enter');
    await whole;
    const again = told(page, now => now.left_out);
    await page.getByRole('button', {name: 'Undo'}).click();
    await again;
    check((await served.api('signals')).left_out.length === 2, 'Undo goes back to what was left out');
    await end(page);
    served.end();
  },

  // A candidate seen before it is added, a parameter fixed, recordings side by side.
  async compare() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await idle(page);
    await page.getByRole('button', {name: /^Preview it/}).click();
    await page.waitForSelector('#preview:not([hidden]) table');
    check((await served.api('state')).can_undo === false, 'nothing is added by looking');
    check((await page.locator('#charts').innerText()).includes('with stiction'), 'its curve is drawn');
    await sound(page, 'preview');
    await shot(page, 'preview-1400-light');
    await page.keyboard.press('Enter');  // the button that adds has the focus
    await page.waitForSelector('#added:not([hidden])');
    await idle(page);
    check((await page.locator('#preview').isHidden()), 'the preview is gone');
    await page.locator('#play summary').click();
    const gain = Number((1.1 * (await served.api('models')).models.at(-1).process.gain.value).toPrecision(4));
    await page.getByRole('textbox', {name: 'process: gain, as a number'}).fill(String(gain));
    await page.keyboard.press('Tab');
    await page.getByRole('checkbox', {name: 'process: gain, fixed'}).check();
    await page.getByRole('button', {name: 'Fit from here'}).click();
    await page.waitForSelector('#added:text("Fitted from there")');
    check((await served.api('models')).models.at(-1).process.gain.value === gain, 'the gain stays');
    await idle(page);
    await page.setInputFiles('#beside-file', loopAlone());
    await page.waitForSelector('#beside svg[role=img]');
    await page.setInputFiles('#beside-file', wideExport('again.csv'));
    await page.waitForSelector('#columns:not([hidden]) .loops');  // two loops: not to be guessed
    await page.getByRole('button', {name: 'Cancel', exact: true}).click();
    const beside = (await served.api('beside')).recordings[0].fit_percent;
    check(beside > 50 && Math.abs(beside - (await served.api('state')).model.fit_percent) < 5,
      'the same loop fits as well');
    await page.locator('#beside').scrollIntoViewIfNeeded();
    await sound(page, 'beside');
    await shot(page, 'beside-1400-light');
    await page.getByRole('button', {name: 'Close alone.csv'}).click();
    await page.waitForFunction(() => !document.querySelector('#beside table'));
    await end(page);
    served.end();
  },

  // What the file says is in manual is marked and left out.
  async manual() {
    const served = await serve(inManual());
    const page = await look(served.address);
    await page.waitForSelector('#valve h1:not(.waits)');
    await page.waitForSelector('#facts :text("2 × in manual")');
    check(!(await page.locator('#facts').innerText()).includes('manual mode?'), 'told once');
    await idle(page);
    await sound(page, 'manual');
    await shot(page, 'manual-1400-light');
    await page.getByRole('button', {name: 'Leave out what is in manual'}).click();
    await until(page, async () => (await (await fetch('/api/signals')).json()).left_out.length === 2);
    await page.waitForSelector('#range :text("Grey stretches are left out.")');
    check(await page.getByRole('button', {name: 'Leave out what is in manual'}).count() === 0, 'offered once');
    await page.waitForSelector('#valve.bad');
    await page.locator('#charts').scrollIntoViewIfNeeded();
    await shot(page, 'manual-left-out-1400-light');
    await end(page);
    served.end();
  },

  // Another day of the same export needs no second choice of columns; what differs is asked.
  async alike() {
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await page.setInputFiles('#file', wideExport());
    await page.locator('#columns .loops button').first().click();
    await idle(page);
    await page.setInputFiles('#beside-file', wideExport('tuesday.csv'));
    await page.waitForSelector('#part-0');
    check(await page.locator('#columns').isHidden(), 'nothing is asked');
    await page.setInputFiles('#beside-file', renamed());
    await page.waitForSelector('#columns:not([hidden]) .loops button');
    await shot(page, 'alike-columns-1400-light');
    await page.locator('#columns .loops button').first().click();
    await page.waitForSelector('#part-1');
    check(await page.locator('#columns').isHidden(), 'chosen');
    check((await served.api('state')).recording.name === 'historian.csv', 'the first stays open');
    await page.selectOption('#part-0', 'fit');
    await page.waitForSelector('#added:text("The model was fitted anew to")');
    await idle(page);
    const lines = (await served.api('commands')).commands;
    check(lines.some(line => /^stickband model historian\.csv --.* tuesday\.csv -o m\.json$/.test(line)), lines);
    check(lines.some(line => /^stickband compare .* --validate renamed\.csv$/.test(line)), lines);
    check(lines.some(line => /^# renamed\.csv was read with .*FIC301\.OP/.test(line)), lines);
    await shot(page, 'alike-1400-light', true);
    await end(page);
    served.end();
  },

  // One model of several recordings, while another only judges.
  async together() {
    const [first, second, third] = loopInParts();
    const served = await serve(first);
    const page = await look(served.address);
    await idle(page);
    await page.setInputFiles('#beside-file', second);
    await page.waitForSelector('#part-0');
    await page.setInputFiles('#beside-file', third);
    await page.waitForSelector('#part-1');
    check((await page.locator('#added').isHidden()), 'nothing was fitted yet');
    await page.selectOption('#part-0', 'fit');
    await page.waitForSelector('#added:text("The model was fitted anew to part-1.csv, part-2.csv")');
    await idle(page);
    const state = await served.api('state');
    check(state.model.fitted_to === 'part-1.csv, part-2.csv' && state.model.fitted_here, state.model.fitted_to);
    check(String(state.beside_fitted) === 'true,false', state.beside_fitted);
    check(state.recording.samples === 2200, 'both are open:', state.recording.samples);
    // Each recording in its own colour; the one that judges is not in the charts.
    const drawn = await page.locator('#charts').innerText();
    check(drawn.includes('measured y, part-1.csv') && drawn.includes('measured y, part-2.csv') &&
      !drawn.includes('part-3.csv'), drawn);
    // One number: in the tile, in the table of recordings, in the file of the model.
    const rows = await page.locator('#beside tbody tr').allInnerTexts();
    check(rows.length === 4, rows.length, 'rows');
    const shown = text => Number(text).toPrecision(3);
    const validation = shown(rows[3].split('\t')[4]);
    const tile = await page.locator('#tiles .tile:has-text("Validation error") b').innerText();
    check(shown(tile) === validation && validation === Number(state.model.rmse_validation).toPrecision(3),
      'tile, table and state:', tile, validation, state.model.rmse_validation);
    check((await page.locator('#steps').textContent()).includes('fitted anew to part-1.csv, part-2.csv'), 'a step of its own');
    check((await page.locator('#compare').innerText()).includes('fitted to part-1.csv, part-2.csv'), 'labelled side by side');
    check((await page.locator('#valve h1').innerText()) === 'The valve sticks.', 'one verdict of both');
    check((await page.locator('#take pre').innerText()).includes('part-2.csv'), 'commands name both');
    await page.locator('#charts').scrollIntoViewIfNeeded();
    await sound(page, 'together');
    await shot(page, 'together-1400-light', true);
    // Added to the model of both.
    await page.getByRole('button', {name: /^Put stiction .*into the model/}).first().click();
    await page.waitForSelector('#added:not([hidden]):text("Stiction")');
    await idle(page);
    const added = await served.api('beside');
    for (const {fit_percent: fit, name} of added.recordings) check(fit > 50, name, fit);
    // A saved session brings them back as they were.
    const session = await (await fetch(served.address + 'api/session')).text();
    check(JSON.parse(session).beside[0].fitted === true, 'saved');
    await fetch(served.address + 'api/session', {method: 'POST', body: session});
    check(String((await served.api('state')).beside_fitted) === 'true,false', 'restored');
    await page.getByRole('button', {name: 'Show part-1.csv'}).click();
    // Alone again.
    await page.waitForSelector('#part-0');
    await page.selectOption('#part-0', '');
    await until(page, async () => {
      const now = await (await fetch('/api/state')).json();
      return !now.job && now.model?.fitted_to === 'part-1.csv';
    });
    const single = await served.api('state');
    check(single.recording.samples === 1200, 'the first alone:', JSON.stringify([single.recording.name, single.recording.samples, single.beside_fitted, single.model]));
    const narrow = await look(served.address, {width: 390, scheme: 'dark'});
    await narrow.waitForSelector('#part-0');
    await narrow.selectOption('#part-0', 'fit');
    await narrow.waitForSelector('#added:text("fitted anew")');
    await sound(narrow, 'together, narrow');
    await shot(narrow, 'together-390-dark', true);
    await end(narrow);
    await end(page);
    served.end();
  },

  // The third question changes the words.
  async direction() {
    const served = await serve();
    const page = await look(served.address, {width: 390});
    await page.waitForSelector('#open:not([hidden])');
    await page.getByRole('radio', {name: 'no, it closes it'}).check();
    await page.setInputFiles('#file', onOneStroke());
    await page.waitForSelector('#valve.bad');
    const words = await page.locator('#valve').innerText();
    check(/opening|closing|opens|closes/.test(words), 'in the words of the valve:', words);
    // It stays through a reload, and the report says the same.
    await page.reload();
    await idle(page);
    check((await page.locator('#valve').innerText()).includes('Stick band, opening'), 'after a reload');
    const report = await (await fetch(served.address + 'api/report')).text();
    check(report.includes('Stick band, opening') && !/Stick band, (ascending|rising)/.test(report), 'the report says the same');
    await sound(page, 'direction');
    await shot(page, 'direction-390-light', true);
    await page.selectOption('#direction', '');
    await page.waitForFunction(() => !/Stick band, (opening|closing)/.test(document.getElementById('valve').innerText));
    await page.selectOption('#direction', 'yes');
    await page.waitForFunction(() => /Stick band, closing/.test(document.getElementById('valve').innerText));
    // Of the next recording nothing was said.
    await page.getByRole('button', {name: 'Open another…'}).click();
    check(await page.locator('[name=opens]:checked').count() === 0, 'asked anew');
    await page.setInputFiles('#file', inManual());
    await page.waitForFunction(() => document.getElementById('what').textContent.startsWith('manual.csv'));
    check((await served.api('state')).opens === '', 'of this one it is unknown');
    await end(page);
    served.end();
  },

  // The other language has every sentence that the page shows.
  async german() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address, {locale: 'de-DE'});
    await idle(page);
    check((await page.locator('#valve h1').innerText()) === 'Das Ventil klemmt.');
    await sound(page, 'German');
    await shot(page, 'verdict-1400-german', true);
    // No sentence of the server stays English: neither on the page nor in the report.
    const download = page.waitForEvent('download');
    await page.getByRole('button', {name: 'Bericht speichern'}).click();
    const report = readFileSync(await (await download).path(), 'utf8');
    check(report.includes('Das Ventil klemmt.') && report.includes('lang="de"'), 'a German report');
    for (const text of [report, await page.innerHTML('main')]) {
      const words = text.replace(/<(style|code|script|option|noscript)[^>]*>.*?<\/\1>/gs, '').replace(/<[^>]*>/g, ' ');
      const english = words.match(/[^.]{0,30}\b(the|and|with|of the|error|samples)\b[^.]{0,30}/);
      check(!english, 'English is left:', english?.[0]);
    }
    const asked = await look(served.address + '?lang=de');
    check(await asked.evaluate(() => document.documentElement.lang) === 'de', 'asked for by the address');
    await asked.selectOption('#language', 'en');
    await asked.waitForFunction(() => document.documentElement.lang === 'en');
    await end(asked);
    await page.selectOption('#language', 'en');
    await page.waitForFunction(() => document.documentElement.lang === 'en');
    await page.waitForSelector('#valve.bad');
    check((await page.locator('#valve h1').innerText()) === 'The valve sticks.');
    await end(page);
    served.end();
  },

  // What goes wrong is said in German, too.
  async errors() {
    const served = await serve();
    const page = await look(served.address, {locale: 'de-DE'});
    await page.waitForSelector('#open:not([hidden])');
    const rows = count => Array.from({length: count}, (_, k) => `${k},50,${k % 7}`).join('\n');
    for (const [name, text] of [['empty.csv', ''], ['text.csv', 't,u,y\n1,2,3\n2,x,3\n3,4,4'], ['nan.csv', 't,u,y\n1,2,3\n2,2,nan\n3,4,4'],
      ['back.csv', 't,u,y\n1,2,3\n0,1,3\n3,4,4'], ['short.csv', 't,u,y\n1,2,3\n2,3,4\n3,4,4'], ['one.csv', 't,u,y\n1,2,3'],
      ['still.csv', 't,u,y\n' + rows(200)], ['trend.png', '\x89PNG\r\n'], ['other.session.json', '{"kind":"stickband-session"}'],
      ['columns.csv', 'p,q,r\n1,2,1\n2,1,1\n3,4,2'], ['no-time.csv', 'u,y\n1,2\n2,1\n3,4'],
      ['dates.csv', 't,u,y\n03/04/2026 10:00:00,1,2\n04/05/2026 10:00:00,2,3\n05/06/2026 10:00:00,1,2']]) {
      await page.evaluate(() => document.querySelectorAll('#alert, #columns').forEach(box => { box.hidden = true; }));
      await page.setInputFiles('#file', {name, mimeType: 'text/plain', buffer: Buffer.from(text, 'latin1')});
      await page.waitForSelector('#alert:not([hidden]), #columns:not([hidden]) .problem');
      const said = await page.locator('#alert:not([hidden]), #columns:not([hidden]) .problem').first().innerText();
      check(!/\b(the|and|with|an?|of|or|expected|found)\b/.test(said), name, 'is told in English:', said);
    }
    await end(page);
    served.end();
  },

  // The first screen of other loops, at both widths.
  async first() {
    for (const [name, file] of Object.entries(loops())) {
      const served = await serve(file);
      for (const [width, scheme] of [[1400, 'light'], [390, 'dark']]) {
        const page = await look(served.address, {width, scheme});
        await page.waitForSelector('#valve h1:not(.waits)');
        await page.waitForFunction(() => !document.querySelector('#valve .so-far:not([hidden])'));
        await sound(page, `${name}, ${width}`);
        await shot(page, `first-${name}-${width}`);
        await end(page);
      }
      served.end();
    }
  },

  // What is no model, no recording.
  async refused() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await idle(page);
    await page.getByRole('button', {name: 'Open another…'}).click();
    await page.setInputFiles('#file', path('package.json'));
    await page.waitForSelector('#alert:not([hidden])');
    check((await page.locator('#alert').innerText()).includes('package.json'));
    check((await served.api('state')).can_undo === false, 'nothing was taken');
    await end(page);
    served.end();
  },

  // An Excel workbook is read as it is; a damaged one is told.
  async workbook() {
    const file = name => new URL(`../exports/${name}`, import.meta.url).pathname;
    const served = await serve();
    const page = await look(served.address);
    await page.waitForSelector('#open:not([hidden])');
    await page.setInputFiles('#file', file('damaged.xlsx'));
    await page.waitForSelector('#alert:not([hidden])');
    check((await page.locator('#alert').innerText()).includes('damaged.xlsx'));
    await page.setInputFiles('#file', file('workbook-german.xlsx'));
    // Read, and found too short for a model, whichever columns were chosen.
    await page.waitForFunction(() =>
      document.querySelector('#alert').innerText.includes('workbook-german.xlsx'));
    check((await page.locator('#alert').innerText()).includes('60 samples'), 'it was read');
    check(await page.locator('#columns').isHidden(), 'no columns are asked for');
    await shot(page, 'workbook-1400-light');
    await end(page);
    served.end();
  },
};

// A browser on a busy machine may fail once: what fails is asked for once more, and told.
async function passes(name, test) {
  const began = Date.now();
  try {
    await test();
    console.log(`ok ${name}, ${((Date.now() - began) / 1000).toFixed(1)} s`);
    return true;
  } catch (error) {
    console.log(`FAILED ${name}: ${error.stack}\n${faults().join('\n')}`);
    killAll();
    await forget();
    return false;
  }
}

const wanted = process.argv.slice(2);
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  if (wanted.length && !wanted.includes(name)) continue;
  if (!await passes(name, test) && !await passes(name, test)) ++failed;
}
await close();
process.exit(failed ? 1 : 0);
