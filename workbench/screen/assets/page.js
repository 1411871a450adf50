"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const FIELDS = ["name", "verdict", "cost", "up", "down", "unit", "detectable", "nats",
  "period", "share", "group", "leads", "lag", "reason", "cause", "files", "trend", "notes",
  "samples", "ts", "from", "u", "y", "error", "uTag", "yTag"];
const text = (i) => data.texts[i];
const loops = data.rows.map((row) => {
  const loop = {};
  FIELDS.forEach((field, i) => { loop[field] = row[i]; });
  for (const field of ["verdict", "reason", "cause"]) loop[field] = text(loop[field]);
  loop.files = loop.files.map(text);
  loop.notes = loop.notes.map(text);
  if (loop.error) loop.verdict = "not read";
  loop.band = Math.max(loop.up ? loop.up[0] : 0, loop.down ? loop.down[0] : 0);
  const bands = loop.trend.filter((t) => t[3] !== null).map((t) => t[3]);
  loop.rise = bands.length > 1 && bands[0] > 0 ? bands[bands.length - 1] / bands[0] - 1 : null;
  loop.haystack = [loop.name, loop.cause, loop.verdict, loop.error, ...loop.files].join("\n").toLowerCase();
  return loop;
});
const WORDS = { stiction: "sticks", backlash: "has play", no_stiction: "does not stick",
  undecided: "undecided", bad_data: "bad data", "not read": "not read" };
const byId = (id) => document.getElementById(id);
const list = byId("list"), space = byId("space"), rows = byId("rows");

function made(tag, className, content) {
  const out = document.createElement(tag);
  if (className) out.className = className;
  if (content !== undefined) out.textContent = content;
  return out;
}
const plain = (v) => String(v).replace("-", "−");
const four = (v) => (v === null || v === undefined ? "–" : plain(Number(v.toPrecision(3))));
function duration(s) {
  if (!s) return "–";
  if (s < 120) return four(s) + " s";
  if (s < 7200) return four(s / 60) + " min";
  return s < 172800 ? four(s / 3600) + " h" : four(s / 86400) + " d";
}
const percent = (v) => (v === null ? "–" : Math.round(100 * v) + " %");
const interval = (b) => `${four(b[1])} to ${four(b[2])}`;
function bandText(loop) {
  const one = loop.up || loop.down;
  if (!one) return loop.detectable ? ["none seen", `above ${four(loop.detectable)} % of span`] : ["–", ""];
  const unit = loop.unit ? "" : ", in units of u";
  if (loop.up && loop.down && loop.up[0] !== loop.down[0]) {
    return [`${four(loop.up[0])} up, ${four(loop.down[0])} down ${loop.unit}`,
      `${interval(loop.up)}; ${interval(loop.down)}${unit}`];
  }
  return [`${four(one[0])} ${loop.unit}`, interval(one) + unit];
}
function picture(loop) {
  const NS = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(NS, "svg");
  svg.setAttribute("viewBox", "0 0 100 100");
  svg.setAttribute("preserveAspectRatio", "none");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", "u and y of " + loop.name);
  for (const signal of ["u", "y"]) {
    const values = loop[signal];
    if (!values) continue;
    let path = "";
    for (let i = 0; i < values.length; ++i) {
      const x = 100 * i / (values.length - 1);
      const y = 97 - (values.charCodeAt(i) - 33);
      // The controller holds its output from sample to sample.
      path += i && signal === "u" ? `H${x.toFixed(1)}V${y}` : `${i ? "L" : "M"}${x.toFixed(1)} ${y}`;
    }
    const line = document.createElementNS(NS, "path");
    line.setAttribute("d", path);
    line.setAttribute("class", signal);
    svg.append(line);
  }
  return svg;
}
const [SOME, STRONG, ALONE] = data.nats;
const NATS = "How much better a sticking stem tells the next sample than u alone, as the logarithm " +
  `of the odds: below ${SOME} nats it says nothing, from ${ALONE} on it needs nothing beside it.`;
function weight(nats) {
  return nats >= ALONE ? "very strong" : nats >= STRONG ? "strong" : nats >= SOME ? "some" : "none";
}
function trendText(loop) {
  if (loop.rise === null) return [loop.trend.length ? "–" : "", ""];
  const size = Math.round(100 * loop.rise);
  if (Math.abs(size) < 5) return ["steady", ""];
  return [`${size > 0 ? "▲" : "▼"} ${Math.abs(size)} %`, size > 0 ? "up" : "down"];
}
function rowOf(loop, index) {
  const row = made("div", "row");
  row.setAttribute("role", "listitem");
  row.dataset.index = index;
  row.tabIndex = 0;
  const name = made("span", "name");
  const title = made("span");
  title.append(made("b", "", loop.name));
  if (loop.group) title.append(made("span", "group", `group ${loop.group}${loop.leads ? " leads" : ""}`));
  const open = ["undecided", "bad_data"].includes(loop.verdict);
  name.append(title, made("small", open ? "why" : "",
    loop.error || (open ? loop.reason : loop.cause.replace(/_/g, " ") || loop.files[0])));
  name.title = loop.error || loop.reason;
  const verdict = made("span", "verdict");
  verdict.append(made("span", "badge " + loop.verdict.replace(" ", "_"), WORDS[loop.verdict] || loop.verdict));
  const [value, detail] = bandText(loop);
  const band = made("span", "band", value);
  band.append(made("small", "", detail));
  const nats = made("span", "nats", loop.nats === null ? "–" : weight(loop.nats));
  nats.title = NATS;
  if (loop.nats !== null) nats.append(made("small", "", plain(Math.round(loop.nats)) + " nats"));
  const share = made("span", "share", loop.error ? "" : percent(loop.share));
  share.append(made("small", "", loop.period ? "every " + duration(loop.period) : ""));
  const [trend, direction] = trendText(loop);
  const shown = made("span", "picture");
  if (loop.u || loop.y) shown.append(picture(loop));
  row.append(name, verdict, band, nats, share, made("span", "trend " + direction, trend), shown);
  return row;
}

let shown = loops;
let height = 60;
const drawn = new Map();
function draw() {
  const first = Math.max(0, Math.floor(list.scrollTop / height) - 6);
  const last = Math.min(shown.length, Math.ceil((list.scrollTop + list.clientHeight) / height) + 6);
  for (const [index, row] of drawn) {
    if (index < first || index >= last) { row.remove(); drawn.delete(index); }
  }
  for (let i = first; i < last; ++i) {
    if (drawn.has(i)) continue;
    const row = rowOf(shown[i], i);
    row.style.setProperty("position", "absolute");
    row.style.setProperty("top", i * height + "px");
    row.style.setProperty("left", "0");
    row.style.setProperty("right", "0");
    rows.append(row);
    drawn.set(i, row);
  }
}
function redraw() {
  height = parseFloat(getComputedStyle(document.documentElement).getPropertyValue("--height"));
  rows.replaceChildren();
  drawn.clear();
  space.style.setProperty("height", Math.max(1, shown.length * height) + "px");
  if (shown.length === 0) rows.append(made("div", "empty", "No loop fits the search and the verdicts chosen."));
  draw();
}

const off = new Set();
const names = new Intl.Collator("en", { numeric: true });
const ORDERS = {
  cost: () => 0,
  nats: (a, b) => (b.nats ?? -1e9) - (a.nats ?? -1e9),
  band: (a, b) => b.band - a.band,
  share: (a, b) => (b.share ?? -1) - (a.share ?? -1),
  rise: (a, b) => (b.rise ?? -1e9) - (a.rise ?? -1e9),
  group: (a, b) => (a.group || 1e9) - (b.group || 1e9) || b.leads - a.leads || a.lag - b.lag,
  name: (a, b) => names.compare(a.name, b.name),
};
function filter() {
  const words = byId("search").value.toLowerCase().split(/\s+/).filter(Boolean);
  shown = loops.filter((loop) => !off.has(loop.verdict) && words.every((w) => loop.haystack.includes(w)));
  const order = byId("order").value;
  if (order !== "cost") shown.sort(ORDERS[order]);
  byId("count").textContent = shown.length === loops.length ? `${loops.length} loops` : `${shown.length} of ${loops.length} loops`;
  list.scrollTop = 0;
  redraw();
}

function describe(box, entries) {
  const dl = made("dl");
  for (const [name, value] of entries) if (value) dl.append(made("dt", "", name), made("dd", "", value));
  box.append(dl);
}
function open(loop) {
  const box = byId("detail");
  box.replaceChildren();
  const close = made("button", "close", "Close");
  close.addEventListener("click", () => box.close());
  const title = made("h2", "", loop.name);
  title.id = "detail-name";
  box.append(close, title, made("span", "badge " + loop.verdict.replace(" ", "_"), WORDS[loop.verdict] || loop.verdict));
  box.append(made("p", "", loop.error || loop.reason));
  if (loop.u || loop.y) {
    const legend = made("div", "legend");
    legend.append(made("i", "u"), "controller output u", made("i", "y"), "process output y");
    box.append(picture(loop), legend);
  }
  const [band, detail] = bandText(loop);
  if (!loop.error) {
    describe(box, [["Stick band", detail ? `${band} (${detail})` : band],
      ["Evidence", loop.nats === null ? "" : `${weight(loop.nats)}: ${four(loop.nats)} nats, one sample ahead, all windows together. ${NATS}`],
      ["Oscillates", `${percent(loop.share)} of the time` + (loop.period ? `, every ${duration(loop.period)}` : "")],
      ["Moved by", loop.cause.replace(/_/g, " ")],
      ["Recorded", `${loop.samples} samples, one every ${duration(loop.ts)}` + (loop.from ? `, from ${loop.from}` : "")],
      ["Cost of leaving it", `${four(loop.cost)} of 100`]]);
  }
  if (loop.group) {
    const members = loops.filter((other) => other.group === loop.group)
      .sort((a, b) => b.leads - a.leads || a.lag - b.lag);
    const valve = ["stiction", "backlash"].includes(members[0].verdict);
    box.append(made("h3", "", `Group ${loop.group}: ${members.length} loops oscillate together`),
      made("p", "more", valve ? `${members[0].name} leads: its valve is the first to look at; the others follow.`
        : `${members[0].name} leads, but no valve explains this group: look for a load, a tuning or a shared utility.`));
    const names = made("div", "members");
    for (const member of members) {
      const button = made("button", "", member.name + (member.leads ? ", leads" : `, ${duration(member.lag)} later`));
      button.addEventListener("click", () => open(member));
      names.append(button);
    }
    box.append(names);
  }
  if (loop.trend.length) {
    const table = made("table");
    const head = made("tr");
    for (const name of ["", "verdict", "band", "nats", "oscillates"]) head.append(made("th", "", name));
    table.append(head);
    for (const [name, verdict, nats, size, share] of loop.trend) {
      const line = made("tr");
      for (const cell of [name, WORDS[verdict] || verdict, four(size), four(nats), percent(share)]) line.append(made("td", "", cell));
      table.append(line);
    }
    box.append(made("h3", "", "From month to month"), table);
  }
  if (loop.notes.length) {
    const notes = made("ul");
    for (const note of loop.notes) notes.append(made("li", "", note));
    box.append(made("h3", "", "What was done with the recording"), notes);
  }
  box.append(made("h3", "", loop.files.length > 1 ? "Files" : "File"), made("p", "more", loop.files.join("\n")));
  if (!loop.error) {
    const quoted = (word) => (/^[\w./:@+-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`);
    const columns = loop.uTag ? ` --u ${quoted(loop.uTag)} --y ${quoted(loop.yTag)}` : "";
    box.append(made("p", "more", "The full report of this loop:"),
      made("pre", "", `stickband report ${quoted(loop.files[0])}${columns} -o loop.html`));
  }
  if (!box.open) box.showModal();
  box.scrollTop = 0;
}

document.body.classList.toggle("no-trend", loops.every((loop) => loop.trend.length === 0));
const counts = new Map();
for (const loop of loops) counts.set(loop.verdict, (counts.get(loop.verdict) || 0) + 1);
for (const verdict of Object.keys(WORDS)) {
  if (!counts.has(verdict)) continue;
  const chip = made("button", verdict.replace(" ", "_"), `${WORDS[verdict]} ${counts.get(verdict)}`);
  chip.setAttribute("aria-pressed", "true");
  chip.addEventListener("click", () => {
    if (!off.delete(verdict)) off.add(verdict);
    chip.setAttribute("aria-pressed", String(!off.has(verdict)));
    filter();
  });
  byId("chips").append(chip);
}
const counted = (n, one, many) => `${n} ${n === 1 ? one : many}`;
const faulty = (counts.get("stiction") || 0) + (counts.get("backlash") || 0);
const groups = loops.filter((loop) => loop.leads);
const led = groups.filter((loop) => ["stiction", "backlash"].includes(loop.verdict)).length;
byId("summary").textContent = `${faulty} of ${loops.length} loops have a valve that sticks or has play. ` +
  (groups.length ? `${counted(groups.length, "group of loops oscillates", "groups of loops oscillate")} together, ${led} led by a valve. ` : "") +
  (data.complete ? "" : `Stopped early: ${data.left_out} loops were not reached. `) +
  (data.unpaired.length ? `${counted(data.unpaired.length, "tag belongs", "tags belong")} to no loop. ` : "");
byId("search").addEventListener("input", filter);
byId("order").addEventListener("change", filter);
list.addEventListener("scroll", draw, { passive: true });
addEventListener("resize", redraw);
const openRow = (event) => {
  const row = event.target.closest(".row");
  if (row) open(shown[row.dataset.index]);
};
rows.addEventListener("click", openRow);
rows.addEventListener("keydown", (event) => { if (event.key === "Enter") openRow(event); });
byId("detail").addEventListener("click", (event) => { if (event.target === byId("detail")) byId("detail").close(); });
filter();
