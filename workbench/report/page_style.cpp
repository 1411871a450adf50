#include "workbench/report/page_style.hpp"

namespace workbench {

const std::string_view kPalette = R"css(
:root{color-scheme:light dark;--page:#f5f6f8;--card:#fff;--ink:#1a1f26;--soft:#5b6572;
--rule:#e2e5ea;--grid:#eceef2;--usual:#dde2ea;--measured:#7b8592;--setpoint:#0c8599;--two-path:#2563eb;
--valve:#d9480f;--linear:#7c5cbf;--truth:#2b8a3e;--bad:#c92a2a;--bad-soft:#fff0f0;
--good:#1f7a35;--good-soft:#eefaf1;--open:#8a6100;--open-soft:#fff8e1}
@media screen and (prefers-color-scheme:dark){:root{--page:#12151a;--card:#1b2027;
--ink:#e8ebef;--soft:#9ba6b4;--rule:#2c333d;--grid:#262c35;--usual:#3a4452;
--measured:#98a3b1;--setpoint:#3bc9db;
--two-path:#6ea0ff;--valve:#ff8a4c;--linear:#b39ddb;--truth:#69c97f;--bad:#ff8787;
--bad-soft:#331b1d;--good:#69c97f;--good-soft:#16281b;--open:#e9c46a;--open-soft:#2e2714}}
)css";

const std::string kPageStyle = std::string(kPalette) + R"css(*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);
font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
main{max-width:1120px;margin:0 auto;padding:28px 20px 48px}
header p{margin:.2em 0;color:var(--soft)}
h1{font-size:30px;line-height:1.2;margin:.1em 0 .3em;letter-spacing:-.01em}
h2{font-size:18px;margin:0 0 .3em}
section,.verdict{background:var(--card);border:1px solid var(--rule);border-radius:12px;
padding:18px 20px;margin:16px 0}
section>p{margin:.1em 0 .8em;color:var(--soft);max-width:76ch}
.verdict{border-left:6px solid var(--open);background:var(--open-soft)}
.verdict.bad{border-left-color:var(--bad);background:var(--bad-soft)}
.verdict.good{border-left-color:var(--good);background:var(--good-soft)}
.verdict p{margin:.35em 0;max-width:80ch}
.tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(200px,1fr));gap:12px}
.tile{background:var(--card);border:1px solid var(--rule);border-radius:12px;
padding:12px 16px;hyphens:auto;overflow-wrap:anywhere}
.tile b{display:block;font-size:24px;line-height:1.25;font-variant-numeric:tabular-nums}
.tile span{color:var(--soft);font-size:13px;display:block}
figure{margin:0 0 14px}figure:last-child{margin-bottom:0}
figcaption{color:var(--soft);font-size:13px;max-width:90ch;margin-top:4px}
.legend{display:flex;flex-wrap:wrap;gap:4px 18px;font-size:13px;color:var(--soft)}
.legend i{display:inline-block;width:22px;height:0;border-width:3px 0 0;
border-style:solid;margin-right:7px;vertical-align:middle}
.legend i.dashed{border-style:dashed}
.plot{position:relative;overflow-x:auto;overflow-y:hidden}
svg{display:block;width:100%;height:auto}
.grid path{stroke:var(--grid);fill:none}
.ticks text{fill:var(--soft);font-size:12px;font-variant-numeric:tabular-nums}
.ticks text.axis{font-size:12.5px}
.line{fill:none;stroke-width:1.5;stroke-linejoin:round}
.line.dashed{stroke-dasharray:6 4}
.line.broad.measured{stroke-width:2.4;opacity:.7}
.line.broad.truth{stroke-width:3.5;opacity:.55}
.line.fine{stroke-width:1.1;opacity:.75}
.measured{stroke:var(--measured);border-color:var(--measured)}
.setpoint{stroke:var(--setpoint);border-color:var(--setpoint)}
.two-path{stroke:var(--two-path);border-color:var(--two-path)}
.valve{stroke:var(--valve);border-color:var(--valve)}
.linear{stroke:var(--linear);border-color:var(--linear)}
.truth{stroke:var(--truth);border-color:var(--truth)}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(420px,100%),1fr));gap:0 28px}
.usual{fill:var(--usual)}.raised{fill:var(--valve);opacity:.35}
.level{stroke:var(--soft);stroke-dasharray:5 4;fill:none}
.mark{fill:currentColor;stroke:none}.mark.valve{fill:var(--valve)}
.mark.two-path{fill:var(--two-path)}
.ticks.notes text{fill:var(--ink);font-size:14px;font-weight:600}
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(300px,100%),1fr));
gap:20px 28px}
.panels h3,.candidates h3{font-size:15px;margin:0}
.panels p{margin:.1em 0 .4em;color:var(--soft);font-size:13px;line-height:1.4;min-height:2.8em}
.panels p b{color:var(--ink)}
.candidates{list-style:none;padding:0;margin:0}
.candidates li{padding:10px 0;border-top:1px solid var(--rule)}
.candidates li:first-child{border-top:0}
.candidates h3{display:flex;flex-wrap:wrap;align-items:baseline;gap:4px 10px}
.candidates h3 code{font-weight:400;color:var(--soft)}
.candidates p{margin:.3em 0 0;max-width:85ch}
.badge{font-size:12px;font-weight:600;border-radius:99px;padding:1px 10px;
border:1px solid currentColor;color:var(--soft)}
.badge.accepted{color:var(--good);background:var(--good-soft)}
.badge.undecided{color:var(--open);background:var(--open-soft)}
details{margin-top:10px}summary{cursor:pointer;color:var(--soft)}
td.group{font-weight:600;padding-top:14px;text-align:left;white-space:normal}
.guide{stroke:var(--soft);stroke-dasharray:2 3}
.tip{position:absolute;pointer-events:none;background:var(--card);color:var(--ink);
border:1px solid var(--rule);border-radius:8px;padding:6px 10px;font-size:12.5px;
box-shadow:0 3px 12px rgba(0,0,0,.15);white-space:nowrap;display:none;z-index:1}
.tip b{font-variant-numeric:tabular-nums}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{text-align:right;padding:6px 10px;border-bottom:1px solid var(--rule)}
th{font-weight:600;color:var(--soft);font-size:13px}
td{white-space:nowrap}
td:first-child{white-space:normal}
td.text{white-space:normal}td small{color:var(--soft);font-weight:400}
th:first-child,td:first-child{text-align:left;padding-left:0}
th.text,td.text{text-align:left;color:var(--soft)}
.bar{display:grid;grid-template-columns:minmax(110px,230px) 1fr 64px;gap:12px;
align-items:center;margin:5px 0}
.bar i{display:block;height:16px;border-radius:4px;min-width:2px;background:currentColor}
.bar span:first-child{color:var(--soft)}
.bar span:last-child{text-align:right;font-variant-numeric:tabular-nums}
.bar .two-path{color:var(--two-path)}.bar .valve{color:var(--valve)}
.bar .linear{color:var(--linear)}
code{font:13px ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;
overflow-wrap:anywhere}
ul{margin:.2em 0;padding-left:1.2em}
footer{color:var(--soft);font-size:13px}
@media print{:root{--page:#fff;--ink:#000;--soft:#444;--rule:#ccc;--grid:#e6e6e6;
--bad-soft:#fff;--good-soft:#fff;--open-soft:#fff}
@page{size:A4;margin:11mm}
body{font-size:8.5pt;line-height:1.35;background:#fff}main{padding:0;max-width:none}
h1{font-size:15pt;margin:0 0 .2em}h2{font-size:10.5pt}header p{margin:0}
section,.verdict{padding:4px 0;margin:3px 0;border-radius:0}section{border:0;border-top:1px solid var(--rule)}
.verdict{padding:4px 10px}.verdict p{margin:.15em 0;max-width:none}
section>p,.candidates p,figcaption{max-width:none}section>p{margin:0 0 .2em}
.tiles{grid-template-columns:repeat(4,1fr);gap:6px}.tile{padding:3px 8px;border-radius:0}
.tile b{font-size:12pt}.tile span,figcaption,.legend,td small{font-size:7pt}
figure{margin:0 0 3px;break-inside:avoid}figcaption{margin-top:0}
.pair{grid-template-columns:1fr 1fr;gap:0 14px}.pair svg{max-height:50mm}
.panels{grid-template-columns:repeat(4,1fr);gap:4px 10px}.panels p{min-height:0;font-size:7pt;margin:0}
.panels h3,.candidates h3{font-size:8.5pt}.candidates li{padding:3px 0}
table{font-size:8pt}th,td{padding:1px 6px}th{font-size:7.5pt}td.group{padding-top:3px}
.plot svg{max-height:36mm}.pair .plot svg{max-height:48mm}.panels .plot svg{max-height:none}
.candidates li:nth-child(n+4),.candidates+details,details:not([open]){display:none}
.candidates:has(li:nth-child(4))::after{content:attr(data-more);color:var(--soft)}
.verdict,.tile,tr,li{break-inside:avoid}.bar i{print-color-adjust:exact}}
)css";

const std::string_view kPageScript = R"js(
for (const box of document.querySelectorAll('.plot')) {
  const svg = box.querySelector('svg'), data = svg.dataset;
  if (data.still) continue;
  const signals = data.signals === '1';
  const lines = [...svg.querySelectorAll('.line')].map(path => ({
    label: path.dataset.label, paint: path,
    points: path.getAttribute('d').slice(1).split('L').map(p => p.split(' ').map(Number))}));
  const guide = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  guide.setAttribute('class', 'guide');
  svg.append(guide);
  const tip = document.createElement('div');
  tip.className = 'tip';
  box.append(tip);
  const number = v => Number(v.toPrecision(4)).toLocaleString(
    document.documentElement.lang, {maximumSignificantDigits: 4, useGrouping: false});
  const xAt = px => +data.x0 + px * data.kx, yAt = py => +data.y0 + py * data.ky;
  const row = (text, value) => {
    const div = document.createElement('div'), b = document.createElement('b');
    b.textContent = number(value);
    div.append(text + ' ', b);
    return div;
  };
  const hide = () => { tip.style.display = 'none'; guide.removeAttribute('d'); };
  svg.addEventListener('pointerleave', hide);
  svg.addEventListener('pointermove', event => {
    const frame = svg.getBoundingClientRect(), view = svg.viewBox.baseVal;
    const px = (event.clientX - frame.left) * view.width / frame.width;
    const py = (event.clientY - frame.top) * view.height / frame.height;
    if (px < 64 || px > view.width - 14 || py > view.height - 40) return hide();
    tip.replaceChildren(row(signals ? data.at : 'u', xAt(px)));
    if (signals) {
      guide.setAttribute('d', `M${px} 10V${view.height - 40}`);
      for (const line of lines) {
        let low = 0, high = line.points.length - 1;
        while (low < high) {
          const middle = (low + high + 1) >> 1;
          if (line.points[middle][0] <= px) low = middle; else high = middle - 1;
        }
        tip.append(row(line.label, yAt(line.points[low][1])));
      }
    } else {
      tip.append(row('x', yAt(py)));
    }
    tip.style.display = 'block';
    const left = event.clientX - frame.left;
    tip.style.left = (left > frame.width / 2 ? left - tip.offsetWidth - 14 : left + 14) + 'px';
    tip.style.top = Math.max(0, event.clientY - frame.top - tip.offsetHeight / 2) + 'px';
  });
}
)js";

}  // namespace workbench
