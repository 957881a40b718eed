// All numbers, sorted by any column.

const kColumns = [
  {id: 'method', name: 'method', text: true, of: (row) => row.id, show: methodCell},
  {id: 'frame', name: 'frame', text: true, of: (row) => row.moment.name, frames: true},
  ...Object.keys(kErrors).map((y) => ({
                                id: y,
                                name: kErrors[y].name,
                                of: (row) => row.errors?.[y],
                                show: (row) => figure(row.errors?.[y])
                              })),
  {
    id: 'psnr',
    name: 'PSNR dB',
    best: -1,
    frames: true,
    of: (row) => row.frame.error && (row.frame.error.psnr_db ?? Infinity),
    show: (row) => row.frame.error ?
        (row.frame.error.psnr_db === null ? '∞' : row.frame.error.psnr_db.toFixed(2)) :
        '–'
  },
  ...Object.keys(kTimes).map((x) => ({
                               id: x === 'total' ? 'time' : 'own',
                               name: kTimes[x].name,
                               unit: true,
                               of: (row) => row.drawn ? row.times[x].value : null,
                               show: (row) => timeCell(row, x)
                             })),
  {id: 'ratio', name: `× ${kBaseline}`, frames: true, of: ratioOf, show: (row) => figure(ratioOf(row))},
  {
    id: 'memory',
    name: 'memory',
    of: (row) => row.drawn ? row.memory ?? row.frame.memory_bytes : null,
    show: (row) => row.drawn ? bytesText(row.memory ?? row.frame.memory_bytes) : '–'
  },
  {
    id: 'left_out',
    name: 'without',
    text: true,
    frames: true,
    of: (row) => lacks(row.frame).join(', '),
    wrap: true
  },
];

const kRowsInSight = 50;

function methodCell(row) {
  const onFront = row.moment.front?.includes(row);
  return element(
      'span', {class: onFront ? 'on_front' : null, title: input.methods[row.method]?.title},
      symbolElement(row.method), ` ${row.id}${onFront ? ' ★' : ''}`,
      row.drawn ? null : element('span', {class: 'status'}, row.frame.status));
}

function timeCell(row, x) {
  if (!row.drawn) return '–';
  const {value, range} = row.times[x];
  const isCertain = !range || range[0] === range[1];  // the baseline over itself
  return element(
      'span', {}, figure(value), isCertain ? '' : element('span', {class: 'range'}, ` ${rangeText(range)}`));
}

/// Time over that of plain sorted blending in the same moment.
function ratioOf(row) {
  const baseline = row.moment.rows.find((other) => other.id === kBaseline && other.drawn);
  return baseline && row.drawn ? row.times[view.x].value / baseline.times[view.x].value : null;
}

function compareValues(a, b) {
  const missing = (value) => value === null || value === undefined || Number.isNaN(value);
  if (missing(a) || missing(b)) return missing(a) - missing(b);
  return typeof a === 'string' ? a.localeCompare(b, 'en', {numeric: true}) : a - b;
}

function sortedRows(of) {
  const column = kColumns.find((c) => c.id === view.sort);
  if (!column) return of;
  const known = of.filter((row) => ![null, undefined].includes(column.of(row)));
  known.sort((a, b) => (view.down ? -1 : 1) * compareValues(column.of(a), column.of(b)));
  return [...known, ...of.filter((row) => !known.includes(row))];  // what has no number stays below
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    $('copied').replaceChildren('Copied: ', element('code', {}, text));
  } catch {  // a browser that keeps its clipboard from pages on disk
    $('copied').replaceChildren('Copy this: ', element('code', {}, text));
    getSelection().selectAllChildren($('copied').querySelector('code'));
  }
}

function tableOf(of, columns, caption) {
  const heads = columns.map((column) => {
    const sorted = view.sort === column.id;
    return element(
        'th', {
          class: column.text ? 'text' : null,
          scope: 'col',
          'data-column': column.id,
          'aria-sort': sorted ? (view.down ? 'descending' : 'ascending') : 'none'
        },
        element(
            'button', {
              type: 'button',
              onclick: () => change({sort: column.id, down: sorted ? !view.down : column.best === -1})
            },
            column.unit ? `${column.name}, ${of[0].moment.unit}` : column.name));
  });
  const copies = of.some((row) => row.command);
  if (copies) heads.push(element('th', {class: 'text again', scope: 'col'}, 'command'));
  const body = sortedRows(of).map(
      (row) => element(
          'tr', {
            class: row.id === view.method && row.moment.id === view.moment ? 'picked' : null,
            onclick: () => pick(row),
          },
          ...columns.map((column) => {
            const shown = (column.show ?? column.of)(row);
            return element(
                'td',
                {class: [column.text && 'text', column.wrap && 'wrap'].filter(Boolean).join(' ') || null},
                shown ?? '–');
          }),
          copies ? element(
                       'td', {class: 'text again'},
                       element(
                           'button', {
                             type: 'button',
                             title: row.command,
                             onclick: (event) => {
                               event.stopPropagation();
                               copy(row.command);
                             }
                           },
                           'copy')) :
                   null));
  const isLong = of.length > kRowsInSight;
  if (isLong) caption = `${caption ?? 'All'}: ${of.length} rows, of which the rest is below: scroll.`;
  return element(
      'div', {class: isLong ? 'scroll long' : 'scroll', tabindex: '0'},
      element(
          'table', {}, caption ? element('caption', {}, caption) : null,
          element('thead', {}, element('tr', {}, ...heads)), element('tbody', {}, ...body)));
}

function pick(row) {
  change(
      row.moment.id === view.moment ? {method: row.id} :
                                      {moment: row.moment.id, method: row.id, against: '', pixel: ''});
}

function drawTable() {
  for (const moment of views) {
    const measured = moment.rows.filter((row) => row.measured && row.times[view.x].value > 0);
    moment.front = paretoFront(measured, view.x, view.y);
  }
  const moment = shownMoment();
  if (!moment) return;
  const withRatio = (columns) =>
      moment.rows.some((row) => row.id === kBaseline) ? columns : columns.filter((c) => c.id !== 'ratio');
  const leaves = rows.some((row) => lacks(row.frame).length);
  const columns = withRatio(kColumns).filter((column) => column.id !== 'left_out' || leaves);
  const tables = isMean() ?
      [
        tableOf(
            moment.rows, columns.filter((column) => !column.frames),
            timeUnit() === '×' ?
                `Over all ${moments.length} frames: mean errors; times as geometric means of the ratio to ${
                    kBaseline}; the most memory of any` :
                `Over all ${moments.length} frames: mean errors; geometric means of times; the most memory of any`),
        tableOf(rows, columns, 'Every frame')
      ] :
      [tableOf(moment.rows, columns.filter((column) => column.id !== 'frame'))];
  tables.forEach((table, i) => {
    const before = $('tables').children[i];
    if (!before) return;
    table.dataset.top = before.scrollTop;
    table.dataset.left = before.scrollLeft;
  });
  const focused = document.activeElement?.closest?.('th')?.dataset.column;
  $('tables').replaceChildren(...tables.flatMap((table, i) => i ? [element('br'), table] : [table]));
  if (focused) $('tables').querySelector(`th[data-column="${focused}"] button`)?.focus();
  document.documentElement.dataset.rows = tables.at(-1).querySelectorAll('tbody tr').length;
  document.documentElement.dataset.firstRow = tables[0].querySelector('tbody td').textContent.trim();
}

drawers.push((changed) => {
  if (!changed.size || ['sort', 'down', 'moment', 'method', 'x', 'y'].some((name) => changed.has(name)))
    drawTable();
});
