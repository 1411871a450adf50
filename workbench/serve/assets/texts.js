// The page's words. English is the source; every other language is a file in texts/ that
// gives the same sentence for each, with {0}, {1} where something is filled in. What a
// table lacks stays English. report/texts.cpp says the reports in the same way.
import tables from './texts/all.js';

const TABLES = {en: {}, ...tables};
const KEY = 'stickband-language';

const chosen = () => {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
};

const asked = new URL(location.href);  // ?lang=de

export const language = [asked.searchParams.get('lang'), chosen(), navigator.language.slice(0, 2), 'en']
  .find(code => Object.hasOwn(TABLES, code ?? ''));

const table = TABLES[language];

export function choose(code) {
  localStorage.setItem(KEY, code);
  asked.searchParams.delete('lang');
  if (asked.href === location.href) location.reload(); else location.replace(asked);
}

// Sentences with gaps, as the server fills them (recording/filled.hpp): tried where no
// sentence fits as it is, the longest first. In a short one the gaps take single words, or
// it would fit almost anything.
const SHORT = 7, SHORT_COUNT = 10;  // "3 backlash"
const patterns = Object.entries(table).filter(([english]) => /\{\d\}/.test(english))
  .map(([english, other]) => {
    const fixed = english.replace(/\{\d\}/g, '').length;
    const short = fixed < (/^\{0\} [^:]*$/.test(english) ? SHORT_COUNT : SHORT);
    const gap = short && /^\w|^\{/.test(english) ? '((?!\\+\\s)\\S+?)' : '(.+?)';
    const gaps = [...english.matchAll(/\{(\d)\}/g)].map(match => Number(match[1]));
    return {fixed, gaps, other, pattern: new RegExp('^' + english
      .replace(/[.*+?^$()|[\]\\]/g, '\\$&').replace(/\{\d\}/g, gap) + '$', 's')};
  }).sort((a, b) => b.fixed - a.fixed);

const fill = (text, values) => text.replace(/\{(\d)\}/g, (_, i) => values[i]);

// A sentence of the page: `english` is the key.
export const say = (english, ...values) => fill(table[english] ?? english, values);

// What each language calls itself.
export const LANGUAGES = Object.fromEntries(Object.entries(TABLES).map(([code, own]) =>
  [code, own['the name of the language'] ?? 'English']));

// Numbers within words as the language writes them; those of the page are so already.
const mark = say('1.5').slice(1, -1);
// What is quoted is the file's own.
const withMark = text => text.replace(/'[^']*'|(^|[^\d.])(\d+)\.(\d+)(?!\d|\.\S)/g,
  (found, before, whole, part) => part === undefined ? found : before + whole + mark + part);

// One sentence, or one that the table has as a whole; null where it lacks it.
function known(bare) {
  if (Object.hasOwn(table, bare)) return table[bare];
  const lower = bare.charAt(0).toLowerCase() + bare.slice(1);
  if (Object.hasOwn(table, lower)) {
    const other = table[lower];
    return other.charAt(0).toUpperCase() + other.slice(1);
  }
  for (const {pattern, gaps, other} of patterns) {
    const match = pattern.exec(bare);
    if (!match) continue;
    // A gap is no place for the end of one sentence and the begin of another.
    if (match.slice(1).some(text => /[.!?] [A-ZÄÖÜ]/.test(text) && known(text) === null)) continue;
    const values = [];
    gaps.forEach((gap, i) => { values[gap] = translated(match[i + 1]); });
    return fill(other, values);
  }
  return null;
}

// Of the server's sentences one after the other as many at a time as the table knows.
function inTurn(sentences) {
  const out = [];
  for (let i = 0; i < sentences.length;) {
    let found = null, to = sentences.length;
    for (; to > i && found === null; --to) found = known(sentences.slice(i, to).join(' '));
    out.push(found ?? withMark(sentences[i]));
    i = found === null ? i + 1 : to + 1;
  }
  return out.join(' ');
}

// A list of names: "a, b or c"; codes of effects stay.
function listed(bare) {
  const names = bare.split(/, | or | and | with /), words = bare.match(/, | or | and | with /g);
  if (!words) return null;
  const others = names.map(name => known(name) ?? (/^\w+\.\S+$/.test(name) ? name : null));
  if (others.includes(null)) return null;
  const between = {', ': ', ', ' or ': say(' or '), ' and ': say(' and '), ' with ': say(' with ')};
  return others.map((name, i) => name + (between[words[i]] ?? '')).join('');
}

// A text of the server, whole, sentence by sentence or with its gaps filled; as it is where
// the table lacks it.
export function translated(text) {
  const bare = text.trim().replace(/\s+/g, ' ');
  if (!bare || language === 'en') return text;
  const other = known(bare) ?? listed(bare) ?? inTurn(bare.split(/(?<=[.!?]) (?=[A-ZÄÖÜ])/));
  return text.replace(text.trim(), () => other);
}

// All texts and labels below `root`.
export function translate(root) {
  if (language === 'en') return;
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  const nodes = [];
  while (walker.nextNode()) nodes.push(walker.currentNode);
  for (const node of nodes) {
    if (/^(code|script|style)$/i.test(node.parentNode?.localName)) continue;
    const now = translated(node.data);
    if (now !== node.data) node.data = now;
  }
  for (const name of ['aria-label', 'title', 'placeholder', 'data-more']) {
    for (const item of root.querySelectorAll(`[${name}]`)) {
      item.setAttribute(name, translated(item.getAttribute(name)));
    }
  }
}
