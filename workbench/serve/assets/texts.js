// The page's words. English is the source; every other language is a file in texts/ that
// gives the same sentence for each, with {0}, {1} where something is filled in. What a
// table lacks stays English.
import de from './texts/de.js';

const TABLES = {en: {}, de};
const KEY = 'stickband-language';

const chosen = () => {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
};

export const LANGUAGES = {en: 'English', de: 'Deutsch'};
export const language = [chosen(), navigator.language.slice(0, 2), 'en']
  .find(code => Object.hasOwn(TABLES, code ?? ''));

const table = TABLES[language];

export function choose(code) {
  localStorage.setItem(KEY, code);
  location.reload();
}

// Sentences with gaps, as the server fills them: tried where no sentence fits as it is.
const patterns = Object.entries(table).filter(([english]) => english.includes('{0}'))
  .map(([english, other]) => [new RegExp('^' + english
    .replace(/[.*+?^$()|[\]\\]/g, '\\$&').replace(/\{\d\}/g, '(.+?)') + '$', 's'), other]);

const fill = (text, values) => text.replace(/\{(\d)\}/g, (_, i) => values[i]);

// A sentence of the page: `english` is the key.
export const say = (english, ...values) => fill(table[english] ?? english, values);

// A text of the server, whole or with its gaps filled; as it is where the table lacks it.
export function translated(text) {
  const bare = text.trim().replace(/\s+/g, ' ');
  if (!bare || language === 'en') return text;
  if (Object.hasOwn(table, bare)) return text.replace(text.trim(), () => table[bare]);
  const lower = bare.charAt(0).toLowerCase() + bare.slice(1);
  if (Object.hasOwn(table, lower)) {
    const other = table[lower];
    return text.replace(text.trim(), () => other.charAt(0).toUpperCase() + other.slice(1));
  }
  for (const [pattern, other] of patterns) {
    const match = pattern.exec(bare);
    if (match) return text.replace(text.trim(), () => fill(other, match.slice(1).map(translated)));
  }
  return text;
}

// All texts and labels below `root`.
export function translate(root) {
  if (language === 'en') return;
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  const nodes = [];
  while (walker.nextNode()) nodes.push(walker.currentNode);
  for (const node of nodes) {
    if (/^(code|script|style)$/i.test(node.parentNode.localName)) continue;
    const now = translated(node.data);
    if (now !== node.data) node.data = now;
  }
  for (const name of ['aria-label', 'title', 'placeholder']) {
    for (const item of root.querySelectorAll(`[${name}]`)) {
      item.setAttribute(name, translated(item.getAttribute(name)));
    }
  }
}
