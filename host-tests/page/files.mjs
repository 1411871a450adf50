// Recordings for the tests of the page.
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {STICKBAND, path} from './served.mjs';

function simulated(scenario, name, seed = 2) {
  execFileSync(STICKBAND, ['simulate', scenario, '--seed', String(seed), '-o', path(name)]);
  return path(name);
}

// A sticking valve, a healthy one, and a recording that cannot tell.
export const loops = () => ({
  healthy: simulated('setpoint', 'healthy.csv', 3),
  undecided: simulated('random-load', 'undecided.csv', 1),
});

// A valve that sticks on one stroke only.
export const onOneStroke = () => simulated('stiction-one-sided', 'one-stroke.csv');

// Steps of u, a gap, and a while in manual.
export function stepped() {
  const rows = readFileSync(simulated('stiction-setpoint', 'one-loop.csv'), 'utf8').trim().split('\n')
    .slice(1).map(row => row.split(',').map(Number));
  const lines = ['Time,OP,PV'];
  rows.forEach(([t, u, y], k) => {
    if (k > 700 && k < 760) return;
    const manual = k > 1500 && k < 1700, moved = k > 2000 && k < 2100;
    lines.push([t, manual ? 55 : moved ? u + 8 : u, y].join(','));
  });
  writeFileSync(path('stepped.csv'), lines.join('\n') + '\n');
  return path('stepped.csv');
}

// The wide export with other names of the first loop.
export function renamed() {
  writeFileSync(path('renamed.csv'), readFileSync(wideExport('tuesday.csv'), 'utf8').replaceAll('FIC101', 'FIC301'));
  return path('renamed.csv');
}

// The loop of the wide export by itself, with its sample period of one second.
export function loopAlone() {
  const rows = readFileSync(path('one-loop.csv'), 'utf8').trim().split('\n').slice(1).map(row => row.split(','));
  writeFileSync(path('alone.csv'), ['t,u,y', ...rows.map(([, u, y], k) => [k, u, y].join(','))].join('\n') + '\n');
  return path('alone.csv');
}

// Half a million rows, the last one `torn` or whole.
export function many(name, last = '5e5,50,50') {
  const rows = Array.from({length: 5e5}, (_, k) => `${k},${50 + k % 7},${50 + Math.sin(k / 9).toFixed(3) * 5}`);
  writeFileSync(path(name), ['t,u,y', ...rows, last].join('\n') + '\n');
  return path(name);
}

// The same with a counter in place of the times.
export function counted(name = 'Sample', step = 1) {
  const rows = readFileSync(loopAlone(), 'utf8').trim().split('\n').slice(1).map(row => row.split(','));
  writeFileSync(path('counted.csv'), [`${name},OP,PV`, ...rows.map(([, u, y], k) => [k * step, u, y].join(','))].join('\n') + '\n');
  return path('counted.csv');
}

// The loop under a load that comes halfway, behind a longer dead time, with a sensor that spikes.
export function loaded() {
  const rows = readFileSync(simulated('stiction-setpoint', 'one-loop.csv'), 'utf8').trim().split('\n')
    .slice(1, 801).map(row => row.split(',').map(Number));
  writeFileSync(path('loaded.csv'), ['t,u,y', ...rows.map(([t, u], k) =>
    [t, u, rows[Math.max(0, k - 12)][2] + (k > 400 ? 6 : 0) + (k % 97 === 5 ? 8 : 0)].join(','))].join('\n') + '\n');
  return path('loaded.csv');
}

// The loop with two stretches in manual, as its column of modes says.
export function inManual() {
  const rows = readFileSync(simulated('stiction-setpoint', 'one-loop.csv'), 'utf8').trim().split('\n')
    .slice(1).map(row => row.split(',').map(Number));
  const lines = ['Time,FIC101.OP,FIC101.PV,FIC101.MODE', ...rows.map(([t, u, y], k) => {
    const manual = k > 600 && k < 760 || k > 1500 && k < 1700;
    return [t, manual ? 52 : u, y, manual ? 'MAN' : 'AUTO'].join(',');
  })];
  writeFileSync(path('manual.csv'), lines.join('\n') + '\n');
  return path('manual.csv');
}

// The same loop in three recordings.
export function loopInParts() {
  const [head, ...rows] = readFileSync(simulated('stiction-setpoint', 'one-loop.csv'), 'utf8').trim().split('\n');
  return [[0, 1200], [1200, 2200], [2200, 2900]].map(([from, to], i) => {
    const name = path(`part-${i + 1}.csv`);
    writeFileSync(name, [head, ...rows.slice(from, to)].join('\n') + '\n');
    return name;
  });
}

// Two loops side by side as a historian exports them: dates, units, tags, newest first.
export function wideExport(name = 'historian.csv', restingOutput = false) {
  const loop = path('one-loop.csv');
  execFileSync(STICKBAND, ['simulate', 'stiction-setpoint', '--seed', '2', '-o', loop]);
  const rows = readFileSync(loop, 'utf8').trim().split('\n').slice(1).map(row => row.split(',').map(Number));
  const start = Date.UTC(2026, 4, 13, 12, 0, 0);
  const stamp = k => new Date(start + k * 1000).toISOString().slice(0, 19).replace('T', ' ');
  const lines = rows.map(([, u, y, sp], k) => [stamp(k), u.toFixed(3), y.toFixed(3),
    sp.toFixed(3), (restingOutput ? 50 : 50 + Math.sin(k / 40)).toFixed(3), (20 + Math.cos(k / 40)).toFixed(3)].join(';'));
  const head = 'Timestamp;FIC101.OP [%];FIC101.PV [m3/h];FIC101.SP [m3/h];TIC205.OP [%];TIC205.PV [degC]';
  writeFileSync(path(name), [head, ...lines.reverse()].join('\n') + '\n');
  return path(name);
}

// 100,000 rows: the loop there and back again, with noise.
export function longRecording(rows = 100000) {
  wideExport();
  const loop = readFileSync(path('one-loop.csv'), 'utf8').trim().split('\n').slice(1)
    .map(row => row.split(',').map(Number));
  const n = loop.length, lines = ['t,u,y'];
  for (let k = 0; k < rows; ++k) {
    const at = Math.floor(k / n) % 2 ? n - 1 - k % n : k % n;
    const noise = ((k * 7919) % 1000 / 1000 - 0.5) * 0.05;
    lines.push(`${(k * 0.67).toFixed(2)},${loop[at][1].toFixed(4)},${(loop[at][2] + noise).toFixed(4)}`);
  }
  writeFileSync(path('long.csv'), lines.join('\n') + '\n');
  return path('long.csv');
}
