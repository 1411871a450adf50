// Long signals at the width of a screen: of each stretch its mean, least and largest.

// Samples a pixel above which a line would be a block of colour.
const DENSE = 4;

const firstAtLeast = (t, value) => {
  let low = 0, high = t.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (t[middle] < value) low = middle + 1; else high = middle;
  }
  return low;
};

// Lowest and highest value of lists; null is no value.
export function extent(lists) {
  let low = Infinity, high = -Infinity;
  for (const list of lists) {
    for (const value of list) {
      if (value == null) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

// What lies between `min` and `max`, and one sample on either side.
export function stretch(t, min, max) {
  return [Math.max(firstAtLeast(t, min) - 1, 0), Math.min(firstAtLeast(t, max) + 1, t.length)];
}

// {t, dense, signals: [{mean, low, high}]} of samples first … last at `pixels` pixels; low
// and high are empty where every sample is drawn. A null is left out; all three are null
// where nothing else is there.
export function envelope(t, signals, [first, last], pixels) {
  const count = last - first;
  if (count <= DENSE * pixels) {
    return {t: t.slice(first, last), dense: false, signals: signals.map(values =>
      ({mean: values.slice(first, last), low: [], high: []}))};
  }
  const at = new Array(pixels);
  for (let i = 0; i < pixels; ++i) {
    const from = first + Math.floor(i * count / pixels);
    const to = first + Math.floor((i + 1) * count / pixels);
    at[i] = (t[from] + t[to - 1]) / 2;
  }
  const thinned = signals.map(values => {
    const mean = new Array(pixels), low = new Array(pixels), high = new Array(pixels);
    for (let i = 0; i < pixels; ++i) {
      const from = first + Math.floor(i * count / pixels);
      const to = first + Math.floor((i + 1) * count / pixels);
      let least = Infinity, most = -Infinity, sum = 0, seen = 0;
      for (let k = from; k < to; ++k) {
        const value = values[k];
        if (value === null) continue;
        if (value < least) least = value;
        if (value > most) most = value;
        sum += value;
        ++seen;
      }
      mean[i] = seen ? sum / seen : null;
      low[i] = seen ? least : null;
      high[i] = seen ? most : null;
    }
    return {mean, low, high};
  });
  return {t: at, dense: true, signals: thinned};
}
