// Which samples are fitted and which only judge: their share and the length of the blocks.
import {post} from './api.js';
import {$, button, element, number, select} from './dom.js';
import {say} from './texts.js';

const SHARES = [50, 60, 70, 80];

export class Split {
  constructor(change) {
    this.change = change;
    this.drawn = -1;
  }

  // `blocks` as in /api/signals.
  show(state, blocks) {
    if (!state.model || !blocks.length) return $('split').replaceChildren();
    if (this.drawn === state.drawn) return;
    this.drawn = state.drawn;
    const {estimation_share: share, block_s: length} = state.split;
    const usual = 2 * (blocks.at(-1)[1] - blocks[0][0]) / blocks.length;
    const wanted = select(SHARES.map(value => [value, `${value} %`]), Math.round(100 * share), () => {});
    const field = element('input', {type: 'text', inputMode: 'decimal', size: 8, autocomplete: 'off',
      value: length > 0 ? String(Number(length.toPrecision(6))) : '', placeholder: number(usual, 3)});
    const go = button(say('Fit with it'), () => {
      const block = Number(field.value.trim().replace(',', '.') || 0);
      if (!Number.isFinite(block) || block < 0) return field.focus();
      this.change(() => post('/api/split',
        {estimation_share: Number(wanted.value) / 100, block_s: block}));
    });
    $('split').replaceChildren(element('details', {open: $('split').querySelector('details')?.open ?? false},
      element('summary', {textContent: say('Which samples are fitted, and which only judge')}),
      element('p', {textContent: say('Fitted and judging blocks take turns, so that whatever sets in halfway is seen on both sides: grey and blue in the strip below the residual.')}),
      element('p', {className: 'options'},
        element('label', {}, element('span', {textContent: say('Fitted') + ' '}), wanted),
        element('label', {}, element('span', {textContent: say('Length of a pair of blocks, s') + ' '}), field), go)));
  }
}
