// A running `stickband serve`, files to open, and a browser that looks at it.
import {spawn} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

export const {STICKBAND, FOLDER, BROWSER_BIN} = process.env;
const require = createRequire(join(FOLDER, 'package.json'));
const {chromium} = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

export const path = name => join(FOLDER, name);
export const check = (holds, ...what) => {
  if (!holds) throw new Error(what.join(' '));
};

const children = new Set();
export const killAll = () => children.forEach(child => child.kill('SIGKILL'));

export async function serve(...options) {
  const child = spawn(STICKBAND, ['serve', ...options, ...options.includes('--port') ? [] : ['--port', '0']]);
  children.add(child);
  child.once('exit', () => children.delete(child));
  const address = await new Promise((resolve, reject) => {
    let said = '';
    child.stdout.on('data', data => {
      said += data;
      const found = /http:\/\/[\d.:]+\//.exec(said);
      if (found) resolve(found[0]);
    });
    child.once('exit', code => reject(new Error(`serve ended with ${code}: ${said}`)));
  });
  const api = async where => (await fetch(address + 'api/' + where)).json();
  return {child, address, api, end: () => child.kill('SIGKILL')};
}

let browser = null;
export const launch = async () => {
  browser ??= await chromium.launch({executablePath: BROWSER_BIN,
    args: ['--no-sandbox', '--disable-dev-shm-usage']});
  return browser;
};
export const close = () => browser?.close();

const pages = new Set();
export const faults = () => [...pages].flatMap(page => page.faults);
export const forget = async () => {
  for (const page of pages) await page.context().close();
  pages.clear();
};

// A page of its own; what goes wrong in it is kept in `faults`.
export async function look(address, {width = 1400, scheme = 'light', locale = 'en-GB'} = {}) {
  const context = await (await launch()).newContext({viewport: {width, height: 900},
    colorScheme: scheme, locale, acceptDownloads: true});
  const page = await context.newPage();
  page.setDefaultTimeout(120000);
  page.faults = [];
  pages.add(page);
  page.on('pageerror', error => page.faults.push(String(error)));
  page.on('console', message => {
    const text = message.text();
    // A server that is gone or refuses is part of some tests.
    if (message.type() === 'error' && !/Failed to load resource|ERR_CONNECTION/.test(text)) {
      page.faults.push(text);
    }
  });
  await page.goto(address);
  return page;
}

export async function end(page) {
  check(page.faults.length === 0, 'faults in the page:', page.faults.join('; '));
  await page.context().close();
  pages.delete(page);
}

// No serious finding of axe-core, nothing wider than the screen.
export async function sound(page, where) {
  await page.evaluate(source => { if (!window.axe) (0, eval)(source); }, axe)
    .catch(async () => page.addScriptTag({content: axe}));
  const found = await page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
  const serious = found.violations.filter(v => ['serious', 'critical'].includes(v.impact));
  check(serious.length === 0, where + ':', serious.map(v =>
    `${v.id}: ${v.nodes.slice(0, 3).map(n => n.target + ' ' + (n.any[0]?.message ?? '')).join(', ')}`).join('; '));
  const wide = await page.evaluate(() =>
    document.documentElement.scrollWidth - document.documentElement.clientWidth);
  check(wide <= 0, where + ':', wide, 'px wider than the screen');
}

export const shot = (page, name, fullPage = false) =>
  page.screenshot({path: path(name + '.png'), fullPage});

// Waits until what is asked in the page holds; unlike waitForFunction it waits for answers.
export async function until(page, holds, seconds = 120) {
  const end = Date.now() + 1000 * seconds;
  while (!await page.evaluate(holds)) {
    check(Date.now() < end, 'it never came true:', holds);
    await page.waitForTimeout(50);
  }
}

// Until the page itself is told of a state that holds, with nothing under way nor about to be:
// what the model lacks is searched for by itself. To be asked for before what leads there; to
// be waited for after it.
export const told = (page, holds) => page.waitForResponse(async answer => {
  if (!answer.url().endsWith('/api/state')) return false;
  const state = await answer.json();
  return !state.job && !state.verdict_job && state.explained !== null && holds(state);
}, {timeout: 120000});

export const idle = page => page.waitForFunction(() =>
  document.getElementById('doing').hidden && !document.getElementById('work').hidden &&
  document.querySelector('#verdict .verdict'));
