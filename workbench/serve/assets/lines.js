// Lines of the charts. Without a graphics processor a browser takes three times as long for
// one path of a thousand edges as for many short ones: each line is drawn in pieces.

const PIECE = 16;  // edges

// Series `which` of a plot of uPlot, in place of its own drawing. Nulls are gaps.
export function drawLine(plot, which) {
  const {ctx, bbox} = plot, {stroke, width, dash} = plot.series[which];
  const [t, values] = [plot.data[0], plot.data[which]], ratio = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.strokeStyle = stroke(plot, which);
  ctx.lineWidth = width * ratio;
  ctx.lineJoin = 'round';
  ctx.lineCap = dash ? 'butt' : 'round';
  if (dash) ctx.setLineDash(dash.map(length => length * ratio));
  ctx.beginPath();
  for (let k = 0, edges = 0; k < t.length; ++k) {
    if (values[k] === null) continue;
    const x = plot.valToPos(t[k], 'x', true), y = plot.valToPos(values[k], 'y', true);
    if (k === 0 || values[k - 1] === null) ctx.moveTo(x, y); else ctx.lineTo(x, y);
    if (dash || ++edges < PIECE) continue;  // each piece would begin its dashes anew
    ctx.stroke();
    ctx.beginPath();
    ctx.moveTo(x, y);
    edges = 0;
  }
  ctx.stroke();
  ctx.restore();
}
