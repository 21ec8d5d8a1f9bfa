// Brings a page to life. Without it the page has its texts, tables and still pictures.
import {arrayOf, fieldValues} from './arrays.js';
import {make, report, save, unit} from './dom.js';
import {historyColumns, startHistory} from './history.js';
import {remembered, startReloading} from './live.js';
import {startMesh} from './mesh.js';

document.documentElement.classList.add('scripted');
const stem = report.name.replace(/^(Run of|Mesh) /, '').replace(/\.(toml|msh)$/, '').replace(/[^\w.-]+/g, '_');

function comesAlive(name) {
  const live = document.getElementById(`${name}-live`), still = document.getElementById(`${name}-static`);
  live.hidden = false;
  still.hidden = true;
  return live;
}
function staysStill(name, reason) {
  document.getElementById(`${name}-live`).hidden = true;
  const still = document.getElementById(`${name}-static`);
  still.hidden = false;
  still.append(make('p', {class: 'note', role: 'status'}, reason));
}

function hasWebGl() {
  try {
    const context = document.createElement('canvas').getContext('webgl2');
    return context !== null;
  } catch {
    return false;
  }
}

const cell = text => /[",\n]/.test(text) ? `"${String(text).replaceAll('"', '""')}"` : String(text);
const plain = value => Number.isNaN(value) ? '' : String(value);

async function saveHistory() {
  const {columns, controlling, verdicts, rows} = await historyColumns(report.history);
  const names = Object.keys(columns), lines = [[...report.history.columns.map(column => column.head), 'controlling_element', 'verdict'].join(',')];
  for (let i = 0; i < rows; ++i)
    lines.push([...names.map(name => plain(columns[name][i])), controlling[i] < 0 ? '' : report.history.elements[controlling[i]],
                report.history.verdictNames[verdicts[i]]].join(','));
  save(`${stem}-history.csv`, 'text/csv', [lines.join('\n'), '\n']);
}

async function saveElements(mesh) {
  const {frame, group, fields, name} = await mesh.elements();
  const lines = [['frame', `time${unit('s', '_')}`, 'element', 'number', ...fields.map(([field]) => cell(field))].join(',')];
  for (let i = 0; i < group.cells.length; ++i)
    lines.push([frame.number, frame.time, name(i), group.ids[i], ...fields.map(([, values]) => plain(values[i]))].join(','));
  save(`${stem}-frame-${frame.number}.csv`, 'text/csv', [lines.join('\n'), '\n']);
}

async function saveAll() {
  const all = {...report};
  const list = values => Array.from(values, v => Number.isFinite(v) ? v : null);
  if (report.history) {
    const {columns, controlling, verdicts} = await historyColumns(report.history);
    all.history = {rows: report.history.rows, allRows: report.history.allRows, elements: report.history.elements};
    for (const [name, values] of Object.entries(columns)) all.history[name] = list(values);
    all.history.controlling_element = Array.from(controlling, e => e < 0 ? null : report.history.elements[e]);
    all.history.verdict = Array.from(verdicts, v => report.history.verdictNames[v]);
  }
  if (report.mesh) {
    const groups = [];
    for (const group of report.mesh.groups) {
      const copy = {...group, frames: []};
      for (const key of ['cells', 'ids', 'triangles', 'owners', 'solid', 'solidNodes']) copy[key] = list(await arrayOf(group[key]));
      for (const frame of group.frames) {
        const codes = await arrayOf(frame.positions), n = group.nodes, axes = [0, 1, 2].map(
            k => Array.from(codes.subarray(k * n, (k + 1) * n), c => frame.min[k] + (frame.max[k] - frame.min[k]) * c / 65535));
        const fields = {};
        for (const field of frame.fields) fields[field.name] = list(await fieldValues(field));
        copy.frames.push({...frame, positions: {x: axes[0], y: axes[1], z: axes[2]}, fields});
      }
      groups.push(copy);
    }
    all.mesh = {...report.mesh, groups};
  }
  save(`${stem}.json`, 'application/json', [JSON.stringify(all)]);
}

/// What a button of the last section does, where the page has it; null: nothing can be saved.
function onSave(name, act) {
  const button = document.getElementById(name);
  if (!button) return;
  button.disabled = act === null;
  if (act) button.addEventListener('click', act);
}

async function start() {
  const parts = {report};
  globalThis.ringwatchReport = parts;  // for tests and for those who look into the console
  if (typeof DecompressionStream === 'undefined') {
    const reason = 'This browser is too old to unpack the data of the page (it has no DecompressionStream).';
    if (report.history) staysStill('history', reason);
    if (report.mesh) staysStill('mesh', reason);
    for (const name of ['save-history', 'save-elements', 'save-json']) onSave(name, null);
    if (report.reloadAfter > 0) startReloading(report.reloadAfter, parts, null);
    return;
  }
  const before = report.reloadAfter > 0 ? remembered() : null;
  if (report.history) parts.history = await startHistory(report, comesAlive('history'), before?.history);
  onSave('save-history', report.history ? saveHistory : null);
  onSave('save-json', saveAll);
  const buttons = document.querySelectorAll('.show-me');
  if (report.mesh && hasWebGl()) {
    parts.mesh = await startMesh(report, comesAlive('mesh'), report.mesh.stepField, before?.mesh);
    for (const button of buttons)
      button.addEventListener('click', () => parts.mesh.showElement(Number(button.dataset.element), Number(button.dataset.frame)));
    onSave('save-elements', () => saveElements(parts.mesh));
  } else {
    if (report.mesh) staysStill('mesh', 'This browser has no WebGL 2, so the mesh cannot be turned.');
    for (const button of buttons) button.hidden = true;
    onSave('save-elements', null);
  }
  if (report.reloadAfter > 0) startReloading(report.reloadAfter, parts, before);
  parts.ready = true;
  parts.readyAfter = performance.now();  // ms since the page was asked for
}

start();
