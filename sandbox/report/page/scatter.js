// Error against time on logarithmic axes, with the front of what is worth its time and ranges of times.

let scatter = null;
let plotted = null;  // {front, bounds, measured, place}: Chart.js would call functions in its options

/// Numbers that a logarithmic axis names: 1, 2 and 5 of each decade, or 1 alone where there are many.
function logTick(value, axis) {
  const leading = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  const decades = Math.log10(axis.max / axis.min);
  const named = decades > 3.2 ? [1] : decades > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9];
  return named.some((digit) => Math.abs(digit - leading) < 1e-6) ? tickFigure(value) : '';
}

/// From and to on a logarithmic axis, with room on both sides; at least a factor of 2 apart.
function logBounds(values, room) {
  let low = Math.log10(Math.min(...values)), high = Math.log10(Math.max(...values));
  if (high - low < 0.3) [low, high] = [(low + high - 0.3) / 2, (low + high + 0.3) / 2];
  const margin = room * (high - low);
  return {min: 10 ** (low - margin), max: 10 ** (high + margin)};
}

/// Where the axes end, and the height of the line for what has no error.
function scatterBounds(measured) {
  const errors = measured.map((row) => errorOf(row, view.y)).filter((error) => error > 0);
  const times = measured.flatMap((row) => {
    const {value, range} = row.times[view.x];
    return range ? [value, ...range.filter((end) => end > 0)] : [value];
  });
  const x = logBounds(times, 0.12);
  const hasExact = errors.length < measured.length;
  if (!errors.length) return {x, y: {min: 1e-6, max: 1e-3}, exact: 2e-6};
  const y = logBounds(errors, 0.12);
  if (!hasExact) return {x, y, exact: null};
  const decades = Math.log10(y.max / y.min);
  return {x, y: {min: y.min / 10 ** (0.16 * decades), max: y.max}, exact: y.min / 10 ** (0.07 * decades)};
}

const scatterDrawing = {
  id: 'plume',
  beforeDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x, y}} = chart;
    const {front, bounds, measured, place} = plotted;
    ctx.save();
    if (bounds.exact) {
      const at = y.getPixelForValue(bounds.exact),
            top = y.getPixelForValue(bounds.exact * (bounds.y.min / bounds.exact) ** -0.75);
      ctx.fillStyle = css('--faint');
      ctx.fillRect(area.left, top, area.width, area.bottom - top);
      ctx.strokeStyle = css('--quiet');
      ctx.setLineDash([2, 4]);
      ctx.beginPath();
      ctx.moveTo(area.left, at);
      ctx.lineTo(area.right, at);
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.fillStyle = css('--quiet');
      ctx.textAlign = 'right';
      ctx.textBaseline = 'middle';
      ctx.fillText('exact', area.left - 6, at);
    }
    if (front.length) {  // stairs: beyond them something is at least as good in both
      ctx.beginPath();
      const corners =
          front.map((row) => place(row)).map((p) => [x.getPixelForValue(p.x), y.getPixelForValue(p.y)]);
      ctx.moveTo(corners[0][0], area.top);
      corners.forEach(([px, py], i) => {
        ctx.lineTo(px, i ? corners[i - 1][1] : area.top);
        ctx.lineTo(px, py);
      });
      ctx.lineTo(area.right, corners.at(-1)[1]);
      ctx.strokeStyle = css('--front');
      ctx.lineWidth = 1.6;
      ctx.globalAlpha = 0.8;
      ctx.stroke();
      ctx.lineTo(area.right, area.top);
      ctx.closePath();
      ctx.globalAlpha = 0.05;
      ctx.fillStyle = css('--front');
      ctx.fill();
      ctx.globalAlpha = 1;
    }
    for (const row of measured) {
      const {range} = row.times[view.x];
      if (!range) continue;
      const py = y.getPixelForValue(place(row).y);
      const [from, to] = range.map((end) => x.getPixelForValue(Math.max(end, x.min)));
      ctx.strokeStyle = symbolOf(row.method).colour;
      ctx.lineWidth = 1.5;
      ctx.beginPath();
      for (const [x0, y0, x1, y1] of [
               [from, py, to, py], [from, py - 4, from, py + 4], [to, py - 4, to, py + 4]]) {
        ctx.moveTo(x0, y0);
        ctx.lineTo(x1, y1);
      }
      ctx.stroke();
    }
    ctx.restore();
  },
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x, y}} = chart;
    const {front, measured, place} = plotted;
    ctx.save();
    ctx.textBaseline = 'alphabetic';
    const others = measured.filter((row) => !front.includes(row));
    const settled = others.filter((row) => row.settings === '');  // names of methods before those of settings
    const points = [...front, ...settled, ...others.filter((row) => row.settings)].map((row) => {
      const at = place(row);
      const [from, to] =
          (row.times[view.x].range ?? [at.x, at.x]).map((end) => x.getPixelForValue(Math.max(end, x.min)));
      return {x: x.getPixelForValue(at.x), y: y.getPixelForValue(at.y), from, to, text: row.id, row};
    });
    const narrow = area.width < 500;
    const cut = (text) => narrow && text.length > 18 ? text.slice(0, 17) + '…' :
        text.length > 44                             ? text.slice(0, 43) + '…' :
                                                       text;
    for (const point of points) point.text = cut(point.text);
    const font = (row) => `${front.includes(row) ? 'bold ' : ''}12px ${Chart.defaults.font.family}`;
    const placed = placeLabels(points, area, (point) => {
      ctx.font = font(point.row);
      return ctx.measureText(point.text).width;
    });
    for (const label of placed) {
      ctx.font = font(label.point.row);
      ctx.lineWidth = 3;
      ctx.strokeStyle = css('--card');
      ctx.strokeText(label.point.text, label.x, label.y + 12);
      ctx.fillStyle = symbolOf(label.point.row.method).colour;
      ctx.fillText(label.point.text, label.x, label.y + 12);
    }
    document.documentElement.dataset.labels = placed.length;
    ctx.restore();
  },
};

/// Cut at spaces into lines of so many letters.
function wrapped(text, most) {
  const lines = [''];
  for (const word of text.split(' '))
    if (!lines.at(-1))
      lines[lines.length - 1] = word;
    else if (lines.at(-1).length + word.length < most)
      lines[lines.length - 1] += ` ${word}`;
    else
      lines.push(word);
  return lines;
}

/// Everything that is known of a row, in lines.
function rowLines(row) {
  const frame = row.frame;
  const lines = [];
  for (const [id, time] of Object.entries(kTimes)) {
    const {value, range} = row.times[id];
    lines.push(`${time.name}: ${timeText(value)}${
        range ? `, surely ${figure(range[0])} to ${figure(range[1])}` : ''}`);
  }
  lines.push(Object.entries(kErrors).map(([y, of]) => `${of.name} ${figure(row.errors[y])}`).join('   '));
  lines.push(`memory: ${bytesText(row.memory ?? frame.memory_bytes)}`);
  if (lacks(frame).length) lines.push(`without ${listText(lacks(frame))}`);
  const alike = shownMoment().rows.filter(
      (other) => other !== row && other.measured && rangesMeet(other.times[view.x], row.times[view.x]));
  if (alike.length) lines.push(`in time not told apart from ${listText(alike.map((other) => other.id))}`);
  if (input.methods[row.method]) lines.push(`known limits: ${input.methods[row.method].limits}`);
  return lines.flatMap((line) => wrapped(line, innerWidth < 700 ? 40 : 80));
}

function drawScatter() {
  const measured = shownMoment().rows.filter((row) => row.measured && row.times[view.x].value > 0);
  const front = paretoFront(measured, view.x, view.y);
  const bounds = measured.length ? scatterBounds(measured) : null;
  const place = (row) => ({x: row.times[view.x].value, y: errorOf(row, view.y) || bounds.exact});
  scatter?.destroy();
  scatter = null;
  $('cost').hidden = !measured.length;
  document.documentElement.dataset.points = measured.length;
  document.documentElement.dataset.front = front.map((row) => row.id).join(', ');
  if (!measured.length) return;

  const datasets = methodOrder
                       .map((method) => {
                         const {colour, shape} = symbolOf(method);
                         const of = measured.filter((row) => row.method === method);
                         return {
                           data: of.map((row) => ({...place(row), row})),
                           pointStyle: shape === 'nabla' ? 'triangle' : shape,
                           rotation: shape === 'nabla' ? 180 : 0,
                           pointRadius: of.map((row) => row.id === view.method ? 9 : 6.5),
                           pointHoverRadius: 9,
                           pointHitRadius: 8,
                           backgroundColor: colour,
                           borderColor: colour,
                           borderWidth: isOpen(shape) ? 2.2 : 1,
                           hoverBorderWidth: 2.5,
                         };
                       })
                       .filter((dataset) => dataset.data.length);
  const narrow = innerWidth < 700;
  const unit = timeUnit() === '×' ?
      (narrow ? `× ${kBaseline}` : `times that of ${kBaseline} (plain sorted blending), geometric mean`) :
      isMean() && !narrow ? 'ms, geometric mean' :
                            'ms';
  plotted = {front, bounds, measured, place};
  scatter = new Chart($('scatter'), {
    type: 'scatter',
    data: {datasets},
    plugins: [scatterDrawing],
    options: {
      layout: {padding: {right: 8, top: 4}},
      onClick: (event, hit) => {
        if (hit.length) change({method: hit[0].element.$context.raw.row.id});
      },
      scales: {
        x: {
          type: 'logarithmic',
          ...bounds.x,
          title: {
            display: true,
            text: `← faster      ${narrow ? '' : 'time on the device, '}${kTimes[view.x].name}, ${unit}`,
            color: css('--ink')
          },
          ticks: {callback: (value) => logTick(value, bounds.x), maxRotation: 0, autoSkipPadding: 10},
          grid: {color: css('--faint')},
        },
        y: {
          type: 'logarithmic',
          ...bounds.y,
          title: {
            display: true,
            text: `← more accurate      ${kErrors[view.y].text}${isMean() ? ', mean' : ''}`,
            color: css('--ink')
          },
          ticks: {
            callback: (value) => bounds.exact && value < bounds.exact * 1.3 ? '' : logTick(value, bounds.y)
          },
          grid: {
            color: (at) =>
                bounds.exact && at.tick?.value < bounds.exact * 1.3 ? 'transparent' : css('--faint')
          },
        },
      },
      plugins: {
        tooltip: {
          callbacks: {
            title: (items) => [...new Set(items.map(
                ({raw: {row}}) =>
                    `${row.id}${input.methods[row.method] ? ` (${input.methods[row.method].title})` : ''}`))],
            label: (item) => rowLines(item.raw.row),
          },
        },
      },
    },
  });
  tellFront(measured, front);
  drawKey(measured);
  const frame = $('scatter').parentElement.getBoundingClientRect();
  document.documentElement.dataset.scatter =
      `${Math.round(frame.top + scrollY)} ${Math.round(frame.height)}`;
}

/// The conclusion in words.
function tellFront(measured, front) {
  const error = (row) =>
      errorOf(row, view.y) === 0 ? 'exact' : `${kErrors[view.y].name} ${figure(row.errors[view.y])}`;
  const place = $('front');
  place.replaceChildren(
      element('strong', {}, `${front.length} of ${measured.length} worth their time`),
      `${isMean() ? ' over all frames' : ' here'}, from the fastest to the most accurate: `);
  const isSure = (i) => !rangesMeet(front[i - 1].times[view.x], front[i].times[view.x]);
  front.forEach((row, i) => {
    place.append(
        i ? (isSure(i) ? ' → ' : ' ~ ') : '', element('strong', {class: 'on_front'}, row.id),
        ` (${timeText(row.times[view.x].value)}, ${error(row)})`);
  });
  place.append('.');
  if (front.some((_, i) => i && !isSure(i)))
    place.append(' Of two with a ~ between them nobody knows which is faster.');
  $('front_limits')
      .replaceChildren(...[...new Set(front.map((row) => row.method))]
                           .filter((method) => input.methods[method]?.limits)
                           .map(
                               (method) => element(
                                   'li', {}, element('strong', {}, method),
                                   `: ${input.methods[method].limits}.`)));
  const ranges = measured.some((row) => row.times[view.x].range);
  $('cost_note').textContent = ranges ?
      'Each bar holds the true median time with 95 % certainty: of two whose bars meet, nobody knows which is faster.' :
      'How certain the times are was not measured here: small differences may be chance.';
  const idle = shownMoment().rows.filter((row) => !row.drawn);
  $('not_drawn').hidden = !idle.length && !(shownMoment().missing?.length);
  $('not_drawn').textContent = [
    ...idle.map((row) => `${row.id}: ${row.frame.status}.`),
    shownMoment().missing?.length ?
        `Not in every frame, so not shown here: ${listText(shownMoment().missing)}.` :
        '',
  ].join(' ');
}

function drawKey(measured) {
  $('key').replaceChildren(
      ...methodOrder.filter((method) => measured.some((row) => row.method === method))
          .map(
              (method) => element(
                  'li', {title: input.methods[method]?.source}, symbolElement(method),
                  element(
                      'span', {}, method, input.methods[method] ? `: ${input.methods[method].title}` : ''))));
}

drawers.push((changed) => {
  if (!changed.size || ['x', 'y', 'moment', 'method'].some((name) => changed.has(name))) drawScatter();
});
