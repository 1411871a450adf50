// Small helpers of the page.
import {language, say} from './texts.js';

export const $ = id => document.getElementById(id);

export function element(tag, attributes = {}, ...children) {
  const out = Object.assign(document.createElement(tag), attributes);
  out.append(...children);
  return out;
}

// `more`: further attributes.
export const button = (textContent, onclick, more = {}) =>
  element('button', {type: 'button', textContent, onclick, ...more});

// A choice among [value, text]; onchange() is called with the value.
export function select(choices, chosen, onchange, more = {}) {
  const out = element('select', more, ...choices.map(([value, textContent]) =>
    element('option', {value, textContent, selected: value === chosen})));
  out.onchange = () => onchange(out.value);
  return out;
}

const SVG = 'http://www.w3.org/2000/svg';
export function drawn(tag, attributes = {}, ...children) {
  const out = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) out.setAttribute(name, value);
  out.append(...children);
  return out;
}

export const capital = text => text.charAt(0).toUpperCase() + text.slice(1);

// Rounded to significant digits, with the decimal mark of the language.
export const number = (value, digits = 3) => value == null || !Number.isFinite(value) ? '–'
  : Number(value.toPrecision(digits)).toLocaleString(language,
    {maximumSignificantDigits: digits, useGrouping: false}).replace('-', '−');

export const withUnit = (text, unit) => unit ? `${text}, ${unit}` : text;

// What is said of the output, with its unit or, unknown, "units of y".
export const withUnitOf = (text, output, units) =>
  `${text}, ${units[output] || say('units of {0}', output)}`;

const MARK = number(1.5).charAt(1), OTHER = MARK === ',' ? '.' : ',';

// As it stands in a field, to be changed.
export const written = (value, digits = 5) => String(Number(value.toPrecision(digits))).replace('.', MARK);

// 1.000 is a thousand to some.
export const mayBeTwo = text =>
  new RegExp(`^[+-]?[1-9]\\d{0,2}(\\${OTHER}\\d{3})+$`).test(text.trim().replace('−', '-'));

export const noNumber = (label, text) =>
  say('{0}: “{1}” is no number, or may be two; write digits and one decimal mark.', label, text.trim());

// What a field says, with either decimal mark; null where it is no number, or may be two.
export function readNumber(text) {
  const bare = text.trim().replace('−', '-');
  if (mayBeTwo(bare)) return null;
  const value = Number(bare.replace(',', '.'));
  return /^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.test(bare) && Number.isFinite(value) ? value : null;
}

export function duration(seconds) {
  const [unit, size] = seconds < 300 ? ['s', 1] : seconds < 7200 ? ['min', 60]
    : seconds < 172800 ? ['h', 3600] : ['d', 86400];
  return `${number(seconds / size)} ${unit}`;
}

export const colour = name =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
