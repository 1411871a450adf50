// The way of a user through the page, in a browser: page_test.mjs [TEST...].
import {copyFileSync, readFileSync} from 'node:fs';
import {check, close, end, faults, forget, idle, killAll, longRecording, look, path, serve, shot, sound, wideExport} from './served.mjs';

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
    check(await page.locator('#valve.bad').count() === 1, 'the verdict stays');
    await page.getByRole('button', {name: /^Put stiction .*into the model/}).first().click();
    await page.waitForSelector('#added:not([hidden])');
    await idle(page);
    check(await page.locator('#valve.bad').count() === 1, 'the verdict stays in its colour');
    check((await page.locator('#valve h1').innerText()) === 'The valve sticks.');
    await sound(page, 'explained');
    await shot(page, 'explained-1400-light', true);
    await page.getByRole('button', {name: 'Undo'}).click();
    await page.waitForFunction(() => !document.getElementById('redo').disabled);
    await page.getByRole('button', {name: 'Redo'}).click();
    await page.waitForFunction(() => document.getElementById('redo').disabled);
    const download = page.waitForEvent('download');
    await page.getByRole('link', {name: 'Save report'}).click();
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
    await reach('#file');
    const chooser = page.waitForEvent('filechooser');
    await page.keyboard.press('Space');
    await (await chooser).setFiles(wideExport());
    await page.waitForSelector('#columns:not([hidden]) li');
    await sound(page, 'columns, narrow');
    await shot(page, 'columns-390-dark');
    for (const [signal, letter] of [['FIC101.OP', 'u'], ['FIC101.PV', 'y']]) {
      await reach(`select[data-signal^="${signal}"]`);
      await page.keyboard.type(letter);
    }
    await reach('#columns .primary');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#valve.bad');
    await page.evaluate(() => scrollTo(0, 0));
    const picture = await page.locator('#valve svg[role=img]').first().boundingBox();
    check(picture.y < 900 && (await page.locator('.todo').boundingBox()).y < picture.y,
      'verdict, band, what to do and the picture begin on the first screen');
    await shot(page, 'verdict-390-dark');
    await idle(page);
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
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await idle(page);
    const before = await page.locator('#verdict').innerText();
    await page.getByRole('button', {name: 'Do all steps'}).click();
    const other = await look(served.address, {scheme: 'dark'});
    await other.waitForSelector('#doing:not([hidden])');
    check((await other.locator('#doing h2').innerText()).includes('step by step'));
    await page.waitForTimeout(500);
    const began = Date.now();
    await page.getByRole('button', {name: 'Stop'}).click();
    check((await page.locator('#doing h2').innerText()) === 'Stopping…' ||
      await page.locator('#doing').isHidden(), 'says that it stops');
    await page.waitForSelector('#doing', {state: 'hidden'});
    console.log(`  Stop to idle: ${Date.now() - began} ms`);
    check((await page.locator('#verdict').innerText()) === before, 'the state before is back');
    await other.waitForSelector('#doing', {state: 'hidden'});
    check((await served.api('state')).can_undo === false, 'nothing was added');
    await end(other);
    await end(page);
    served.end();
  },

  // The program ends while it works.
  async killed() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await page.waitForSelector('#doing:not([hidden])');
    served.end();
    await page.waitForSelector('#alert:not([hidden])');
    check((await page.locator('#alert').innerText()).includes('does not answer'));
    await sound(page, 'killed');
    await end(page);
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
    console.log(`  verdict: ${Date.now() - began} ms`);
    const [script, zoom] = await page.evaluate(async () => {
      const script = [], times = [];
      for (const what of ['in', 'in', 'right', 'in', 'out', 'all', 'in', 'in', 'in', 'all']) {
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
    console.log(`  zoom, script: median ${script[5].toFixed(0)} ms, longest ${script[9].toFixed(0)} ms`);
    console.log(`  zoom to next frame, drawn by software: median ${zoom[5].toFixed(0)} ms, longest ${zoom[9].toFixed(0)} ms`);
    await shot(page, 'long-1400-light');
    await end(page);
    served.end();
  },

  // Parameters by slider, models side by side, a range, and what is taken along.
  async play() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address);
    await page.waitForSelector('#valve.bad');
    await page.waitForSelector('#doing:not([hidden])');
    await page.getByRole('button', {name: 'Stop'}).click();
    await page.waitForSelector('#doing', {state: 'hidden'});
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
    for (const [role, name, what] of [['link', 'Save session', 'session'], ['link', 'Signals as CSV', 'csv'],
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

  // The other language has every sentence that the page shows.
  async german() {
    const served = await serve(wideExport(), '--u', 'FIC101.OP', '--y', 'FIC101.PV');
    const page = await look(served.address, {locale: 'de-DE'});
    await idle(page);
    check((await page.locator('#valve h1').innerText()) === 'Das Ventil klemmt.');
    await sound(page, 'German');
    await shot(page, 'verdict-1400-german', true);
    await page.selectOption('#language', 'en');
    await page.waitForFunction(() => document.documentElement.lang === 'en');
    await page.waitForSelector('#valve.bad');
    check((await page.locator('#valve h1').innerText()) === 'The valve sticks.');
    await end(page);
    served.end();
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
};

const wanted = process.argv.slice(2);
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  if (wanted.length && !wanted.includes(name)) continue;
  const began = Date.now();
  try {
    await test();
    console.log(`ok ${name}, ${((Date.now() - began) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    console.log(`FAILED ${name}: ${error.stack}\n${faults().join('\n')}`);
    killAll();
    await forget();
  }
}
await close();
process.exit(failed ? 1 : 0);
