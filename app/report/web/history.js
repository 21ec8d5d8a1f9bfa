// Bracket, who controls it, and energies, against time with one cursor and one zoom.
import uPlot from 'uplot';
import {arrayOf} from './arrays.js';
import {bound, colourOf, make, number, slider, unit} from './dom.js';

const sideOf = {safe_s: -1, optimistic_s: 1};  // on which a bound of that column is rounded

const logarithmicFrom = 30;  // largest value over the largest step taken, as in charts.cpp

export async function historyColumns(history) {
  const columns = {};
  for (const column of history.columns) columns[column.name] = await arrayOf(column.array);
  const controlling = await arrayOf(history.controlling), verdicts = await arrayOf(history.verdicts);
  return {columns, controlling, verdicts, rows: history.rows};
}

const gaps = (values, positive) => Array.from(values, v => Number.isFinite(v) && (!positive || v > 0) ? v : null);
const hasNumbers = values => values !== undefined && values.some(v => Number.isFinite(v));

/// A colour for each of many elements, in an order that sets neighbours apart.
const elementColour = index => `hsl(${(index * 137.508) % 360} 55% 55%)`;

/// The colour [r, g, b] that draw(context) gives a pixel.
function pixelOf(draw) {
  const context = make('canvas', {width: 1, height: 1}).getContext('2d', {willReadFrequently: true});
  draw(context);
  return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
}

/// before: what view() gave of an earlier page, or undefined.
export async function startHistory(report, place, before) {
  const history = report.history;
  const {columns, controlling, verdicts, rows} = await historyColumns(history);
  const names = history.numbers.length ? history.numbers : history.elements;
  const time = Array.from(columns.time_s);
  const begin = time[0], end = time[time.length - 1];
  const plots = [];
  let bandPlot = -1;  // of `plots`: who controls when
  let logarithmic = null;  // null: as the numbers ask for

  const steps = [['safe_s', 'safe', '--safe', []], ['optimistic_s', 'optimistic', '--optimistic', [6, 3]],
                 ['h_s', 'step taken', '--taken', []], ['metric_step_s', 'step by the metric', '--soft', [2, 3]]]
                    .filter(([name]) => hasNumbers(columns[name]));
  const energies = [['kinetic_J', 'kinetic', '--taken', []], ['strain_J', 'strain', '--safe', []],
                    ['external_work_J', 'external work', '--optimistic', [6, 3]],
                    ['dissipated_J', 'dissipated', '--soft', [2, 3]], ['balance_error_J', 'balance error', '--bad', []]]
                       .filter(([name]) => hasNumbers(columns[name]) && columns[name].some(v => v !== 0));

  const readout = make('p', {class: 'readout', role: 'status', 'aria-live': 'off'});
  const cursorAt = slider('Moment', {min: 0, max: Math.max(0, rows - 1), step: 1, value: 0}, () => pointAt(Number(cursorAt.input.value), true));
  const logButton = make('button', {type: 'button', 'aria-pressed': 'false', onclick: () => {
    logarithmic = !isLogarithmic();
    rebuild();
  }}, 'Logarithmic');
  const button = (text, act) => make('button', {type: 'button', onclick: act}, text);
  const zoom = (factor, shift) => {
    const {min, max} = plots[0].scales.x, width = (max - min) * factor, middle = (min + max) / 2 + shift * (max - min);
    const low = Math.max(begin, Math.min(middle - width / 2, end - width));
    setRange(low, Math.min(end, low + width));
  };
  const controls = make('div', {class: 'buttons', role: 'group', 'aria-label': 'Part of the time that is shown'},
                        button('Closer', () => zoom(0.5, 0)), button('Farther', () => zoom(2, 0)),
                        button('Earlier', () => zoom(1, -0.5)), button('Later', () => zoom(1, 0.5)),
                        button('All', () => setRange(begin, end)), logButton);
  const area = make('div');
  place.append(controls, make('p', {class: 'note'}, 'Drag across a picture to see a part of it, click twice for all.'),
               area, cursorAt.element, readout);

  // Of a run that blows up the energies before would lie on the axis: from a hundred times the usual one on they are
  // compressed. That unit, J; null where none is so large.
  const energyUnit = (() => {
    const all = energies.flatMap(([name]) => Array.from(columns[name], Math.abs)).filter(v => v > 0 && Number.isFinite(v));
    all.sort((a, b) => a - b);
    const usual = all[Math.floor(0.75 * all.length)];
    return all.length && all[all.length - 1] > 100 * usual ? usual : null;
  })();

  /// 0 and powers of ten from the usual energy on, of either sign, few enough for the axis.
  function decades(low, high) {
    const first = Math.ceil(Math.log10(energyUnit)), last = Math.floor(Math.log10(Math.max(high, -low)));
    const stride = Math.max(1, Math.ceil((last - first + 1) / 5)), splits = [0];
    for (let power = first; power <= last; power += stride) splits.push(10 ** power, -(10 ** power));
    return splits.filter(v => v >= low && v <= high).sort((a, b) => a - b);
  }

  function isLogarithmic() {
    if (logarithmic !== null) return logarithmic;
    const largest = name => (columns[name] || []).reduce((most, v) => Number.isFinite(v) ? Math.max(most, v) : most, 0);
    return Math.max(...steps.map(([name]) => largest(name))) > logarithmicFrom * largest('h_s');
  }

  let setting = false;
  function setRange(min, max) {
    if (!(max > min) || setting) return;
    setting = true;
    for (const plot of plots) plot.setScale('x', {min, max});
    setting = false;
  }

  function pointAt(row, fromSlider) {
    if (row === null || row === undefined) return;
    cursorAt.input.value = row;
    cursorAt.output.textContent = `t = ${number(time[row], 6)}${unit('s')}`;
    cursorAt.input.setAttribute('aria-valuetext', `step ${columns.step[row]}, t = ${number(time[row], 6)}${unit('s')}`);
    const texts = [`step ${columns.step[row]}`];
    for (const [name, label] of [...steps, ...energies]) texts.push(`${label} ${bound(columns[name][row], sideOf[name] || 0)}${unit(name.endsWith('_J') ? 'J' : 's')}`);
    const element = controlling[row];
    if (element >= 0) texts.push(`controlled by element ${names[element]}`);
    if (columns.handled_elements && columns.handled_elements[row] > 0) texts.push(`${columns.handled_elements[row]} elements handled`);
    const verdict = history.verdictNames[verdicts[row]];
    if (verdict) texts.push(verdict);
    readout.textContent = texts.join(' · ');
    if (fromSlider && plots.length) {
      const left = plots[0].valToPos(time[row], 'x');
      plots[0].setCursor({left, top: 10});
    }
  }

  const cursorHook = plot => { if (plot.cursor.idx !== null && plot.cursor.left >= 0) pointAt(plot.cursor.idx, false); };
  const rangeHook = (plot, key) => {
    if (key === 'x' && !setting && plot.status === 1) setRange(plot.scales.x.min, plot.scales.x.max);
  };
  function drawMarks(plot) {
    const {ctx, bbox} = plot;
    ctx.save();
    ctx.strokeStyle = colourOf('--mark');
    ctx.setLineDash([3, 4]);
    report.marks.forEach((mark, i) => {
      if (mark.time < plot.scales.x.min || mark.time > plot.scales.x.max) return;
      const x = plot.valToPos(mark.time, 'x', true);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      if (bbox.height < 60 * devicePixelRatio) return;
      ctx.font = `bold ${12 * devicePixelRatio}px sans-serif`;
      ctx.fillStyle = colourOf('--mark');
      ctx.textAlign = 'right';
      // Marks that lie close have their numbers one below the other.
      ctx.fillText(String(i + 1), x - 3, bbox.top + (12 + 13 * (i % 3)) * devicePixelRatio);
    });
    ctx.restore();
  }
  function drawControlling(plot) {
    const {ctx, bbox} = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (let i = 0; i < rows;) {
      let j = i + 1;
      while (j < rows && controlling[j] === controlling[i]) ++j;
      const last = j < rows ? time[j] : time[rows - 1];
      if (controlling[i] >= 0 && last >= plot.scales.x.min && time[i] <= plot.scales.x.max) {
        const left = plot.valToPos(time[i], 'x', true), right = plot.valToPos(last, 'x', true);
        ctx.fillStyle = elementColour(controlling[i]);
        ctx.fillRect(left, bbox.top, Math.max(1, right - left), bbox.height);
        const label = names[controlling[i]];
        ctx.font = `${11 * devicePixelRatio}px sans-serif`;
        ctx.textAlign = 'left';
        if (ctx.measureText(label).width + 6 < right - left) {
          ctx.fillStyle = '#000';
          ctx.textBaseline = 'middle';
          ctx.fillText(label, Math.max(left, bbox.left) + 4, bbox.top + bbox.height / 2);
        }
      }
      i = j;
    }
    ctx.restore();
  }

  function plot(title, height, series, options, keys) {
    const box = make('div', {class: 'plot'}, make('h3', {}, title));
    if (keys) {
      const line = make('p', {class: 'note'});
      for (const [, label, colour, dash] of keys)
        line.append(make('span', {class: 'keyed'}, make('span', {class: 'key', style: `color:var(${colour});border-top-style:${dash.length === 0 ? 'solid' : dash[0] > 3 ? 'dashed' : 'dotted'}`}), label), ' ');
      box.append(line);
    }
    area.append(box);
    const axis = {stroke: colourOf('--soft'), grid: {stroke: colourOf('--grid')}, ticks: {stroke: colourOf('--grid')}, font: '12px sans-serif'};
    const drawn = new uPlot({
      width: Math.max(200, area.clientWidth), height, legend: {show: false}, ...options,
      scales: {x: {time: false}, ...options.scales},
      axes: [{...axis, values: (u, ticks) => ticks.map(t => number(t, 5))},
             {...axis, size: 76, values: (u, ticks) => ticks.map(t => t === null ? '' : number(t, 3)), ...options.yAxis}],
      cursor: {sync: {key: 'time', setSeries: false}, y: false, drag: {x: true, y: false}},
      series: [{}, ...series],
      hooks: {setCursor: [cursorHook], setScale: [rangeHook], draw: [drawMarks, ...(options.draws || [])]},
    }, options.data, box);
    drawn.root.querySelector('canvas').setAttribute('role', 'img');
    drawn.root.querySelector('canvas').setAttribute('aria-label', `${title} against time; the slider below tells its numbers`);
    plots.push(drawn);
  }

  function rebuild() {
    const range = plots.length ? [plots[0].scales.x.min, plots[0].scales.x.max] : null;
    for (const old of plots) old.destroy();
    plots.length = 0;
    area.replaceChildren();
    const log = isLogarithmic();
    logButton.setAttribute('aria-pressed', String(log));
    const line = ([, , colour, dash]) => ({stroke: colourOf(colour), width: 1.8, dash, spanGaps: false, points: {show: rows < 3}});
    plot(`Step${unit('s', ' (', ')')}`, 300, steps.map(line), {
      data: [time, ...steps.map(([name]) => gaps(columns[name], log))],
      scales: {y: log ? {distr: 3} : {range: (u, low, high) => [0, 1.06 * high || 1]}},
    }, steps);
    if (controlling.some(e => e >= 0)) {
      bandPlot = plots.length;
      plot('Who controls when', 96, [{show: false}], {
        data: [time, time.map(() => null)], scales: {y: {range: [0, 1]}}, yAxis: {values: () => [], grid: {show: false}, ticks: {show: false}},
        draws: [drawControlling],
      });
    }
    if (columns.handled_elements && columns.handled_elements.some(v => v > 0))
      plot('Handled elements', 130, [line(['', '', '--mark', []])], {data: [time, gaps(columns.handled_elements, false)], scales: {y: {range: (u, low, high) => [0, 1.1 * high || 1]}}});
    if (energies.length) {
      const log = logarithmic === true, compressed = !log && energyUnit !== null;
      plot(`Energies${unit('J', ' (', ')')}${compressed ? ', large ones compressed' : ''}`, 230, energies.map(line), {
        data: [time, ...energies.map(([name]) => gaps(columns[name], log))],
        scales: {y: log ? {distr: 3} : compressed ? {distr: 4, asinh: energyUnit, range: (u, low, high) => [low, high]} : {}},
        yAxis: compressed ? {splits: (u, axis, low, high) => decades(low, high)} : {},
      }, energies);
    }
    if (range) setRange(...range);
  }

  rebuild();
  new ResizeObserver(() => {
    for (const p of plots)
      if (area.clientWidth > 0 && p.width !== area.clientWidth) p.setSize({width: Math.max(200, area.clientWidth), height: p.height});
  }).observe(area);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', rebuild);
  pointAt(0, false);
  if (before) {
    logarithmic = before.logarithmic;
    rebuild();
    if (before.range) setRange(Math.max(begin, before.range[0]), Math.min(end, before.range[1]));
  }
  return {
    /// What a page that is loaded again shows as before: the part of the time, unless it is all.
    view: () => ({logarithmic, range: plots[0].scales.x.min > begin || plots[0].scales.x.max < end ? [plots[0].scales.x.min, plots[0].scales.x.max] : null}),
    /// In the band of who controls when, halfway from a row to the next: the colour [r, g, b] drawn there, and that of
    /// the element that controls the row.
    bandAt(row) {
      const plot = plots[bandPlot], x = plot.valToPos((time[row] + time[row + 1]) / 2, 'x', true);
      const y = plot.bbox.top + plot.bbox.height - 3;
      return {
        colour: pixelOf(context => context.drawImage(plot.ctx.canvas, Math.round(x), Math.round(y), 1, 1, 0, 0, 1, 1)),
        expected: pixelOf(context => {
          context.fillStyle = elementColour(controlling[row]);
          context.fillRect(0, 0, 1, 1);
        }),
      };
    },
    /// The row of the page that is that step; -1 where the page has left it out.
    rowOf: step => Array.from(columns.step).indexOf(step),
    range: () => [plots[0].scales.x.min, plots[0].scales.x.max], readout: () => readout.textContent,
  };
}
