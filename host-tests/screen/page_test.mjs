// The report of a screening in a browser: page_test.mjs PAGE. Copies its loops until there
// are 5,000, measures the first screen and a filter, and looks at it at two widths.
import {readFileSync, statSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const {FOLDER, BROWSER_BIN} = process.env;
const require = createRequire(join(FOLDER, 'package.json'));
const {chromium} = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const check = (holds, ...what) => {
  if (!holds) throw new Error(what.join(' '));
};
const kLoops = 5000;

const source = readFileSync(process.argv[2], 'utf8');
const begin = source.indexOf('<script type="application/json" id="data">') + 42;
const stop = source.indexOf('</script>', begin);
const data = JSON.parse(source.slice(begin, stop));
const few = data.rows.length;
for (let i = few; i < kLoops; ++i) {
  const row = [...data.rows[i % few]];
  row[0] += '/' + Math.floor(i / few);
  row[10] = 0;
  data.rows.push(row);
}
const path = join(FOLDER, 'screen-5000.html');
writeFileSync(path, source.slice(0, begin) + JSON.stringify(data).replaceAll('<', '\\u003c') +
  source.slice(stop));

const browser = await chromium.launch({executablePath: BROWSER_BIN,
  args: ['--no-sandbox', '--disable-dev-shm-usage']});
try {
  for (const [width, height] of [[1400, 900], [390, 844]]) {
    const page = await browser.newPage({viewport: {width, height}, colorScheme: 'light'});
    const faults = [];
    page.on('pageerror', error => faults.push(String(error)));
    page.on('console', message => message.type() === 'error' && faults.push(message.text()));
    page.on('request', request => request.url().startsWith('file:') ||
      faults.push('asked for ' + request.url()));
    const before = performance.now();
    await page.goto('file://' + path);
    await page.waitForSelector('#rows .row svg');
    const first = performance.now() - before;
    await page.screenshot({path: join(FOLDER, `screen-${width}.png`)});
    const filter = await page.evaluate(async () => {
      const search = document.getElementById('search');
      const took = [];
      for (const words of ['1', 'fic', 'fic 100', '', 'no such loop', '']) {
        const start = performance.now();
        search.value = words;
        search.dispatchEvent(new Event('input'));
        await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
        took.push(performance.now() - start);
      }
      return Math.max(...took);
    });
    const list = page.locator('#list');
    await list.evaluate(box => { box.scrollTop = box.scrollHeight / 2; });
    await page.waitForTimeout(50);
    check(await page.locator('#rows .row').count() < 60, 'rows out of view are drawn');
    check(await page.locator('#rows .row').count() > 5, 'rows in view are missing');
    await list.evaluate(box => { box.scrollTop = 0; });
    await page.waitForTimeout(50);
    check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
      'wider than the window at', width);
    await page.evaluate(axe);
    const found = await page.evaluate(async () =>
      (await axe.run({runOnly: ['wcag2a', 'wcag2aa']})).violations
        .map(v => `${v.id}: ${v.nodes[0].html.slice(0, 120)}`));
    check(found.length === 0, 'axe:', found.join('; '));
    const chips = page.locator('#chips button');
    await chips.first().click();
    check(/ of 5000 loops/.test(await page.locator('#count').innerText()), 'a chip filters');
    await chips.first().click();
    await page.locator('#rows .row').first().click();
    await page.waitForSelector('dialog[open]');
    await page.screenshot({path: join(FOLDER, `screen-detail-${width}.png`)});
    await page.keyboard.press('Escape');
    check(faults.length === 0, faults.join('; '));
    console.log(`${kLoops} loops, ${width} px: first screen ${first.toFixed(0)} ms, slowest ` +
      `filter ${filter.toFixed(0)} ms, ${(statSync(path).size / 1e6).toFixed(1)} MB`);
    await page.close();
  }
} finally {
  await browser.close();
}
