// The page's data, and small helpers for elements, texts and files.

export const report = JSON.parse(document.getElementById('report').textContent);

/// An element with attributes and children: make('button', {type: 'button'}, 'Save').
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

/// A bound to four digits on the side where what it proves stays true: side -1 below, 1 above, 0 for no bound.
export function bound(value, side) {
  const nearest = Number(value.toPrecision(4));
  if (!(value > 0) || !Number.isFinite(value) || side * (nearest - value) >= 0) return number(value);
  return number(value + side * 0.5 * 10 ** (Math.floor(Math.log10(value)) - 3));
}

export function number(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return 'unknown';
  if (!Number.isFinite(value)) return value > 0 ? 'no limit' : '-∞';
  if (value === 0) return '0';
  const rounded = Number(value.toPrecision(digits));
  return Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6 ? rounded.toString() : rounded.toExponential().replace('e+', 'e');
}

/// The page's name of an SI unit between two texts; '' where the page names none.
export function unit(si, before = ' ', behind = '') {
  return report.units[si] && before + report.units[si] + behind;
}

export function save(name, type, parts) {
  const link = make('a', {href: URL.createObjectURL(new Blob(parts, {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function colourOf(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

/// A slider with its label and what it says: {element, input, output}.
export function slider(label, attributes, onInput) {
  const id = `control-${++slider.count}`;
  const input = make('input', {type: 'range', id, ...attributes, oninput: onInput});
  const output = make('output', {for: id});
  return {element: make('div', {}, make('label', {for: id}, `${label}: `, output), input), input, output};
}
slider.count = 0;

export function select(label, options, onChange) {
  const id = `control-${++slider.count}`;
  const input = make('select', {id, onchange: onChange}, ...options.map(([value, text]) => make('option', {value}, text)));
  return {element: make('div', {}, make('label', {for: id}, `${label} `), input), input};
}
