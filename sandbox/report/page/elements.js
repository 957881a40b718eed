// Making parts of the page. Text is always text: nothing in the results is read as markup.

const $ = (id) => document.getElementById(id);

/// element("td", {class: "number"}, "1.5", ...): attributes that start with "on" are listeners.
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name.startsWith('on'))
      made.addEventListener(name.slice(2), value);
    else if (value === true)
      made.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined)
      made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

/// Text whose `names` stand between backticks, as parts for element().
function prose(text) {
  return text.split('`').map((part, i) => i % 2 ? element('code', {}, part) : part);
}

/// Three figures that count, without exponents from 0.0001 on.
function figure(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return '∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(1).split('e');
    return `${mantissa}·10${[...String(Number(exponent))].map((c) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻').join('')}`;
  }
  if (size >= 100) return value.toFixed(0);
  return value.toFixed(Math.min(6, 2 - Math.floor(Math.log10(size))));
}

/// The same on an axis, where nothing is measured: 0.1 and not 0.100.
function tickFigure(value) {
  const text = figure(value);
  return /^-?\d+\.\d+$/.test(text) ? String(Number(text)) : text.replace('1.0·', '');
}

function bytesText(bytes) {
  if (bytes < 1024) return `${bytes} B`;
  if (bytes < 1048576) return `${figure(bytes / 1024)} KiB`;
  return `${figure(bytes / 1048576)} MiB`;
}

/// "a, b and c"
function listText(names) {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}
