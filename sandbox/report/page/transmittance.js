// Transmittance over depth at the pixels that were marked: the exact step function and what methods believe.

let transmittance = null;
const kMostLight = 1.05;   // of the scale: room above clear air
let depthMarksShown = [];  // {depth, text, colour, dash}

/// Of the moment: each marked pixel with the rows that were asked about it.
function probedPixels() {
  const pixels = new Map();
  const moment = isMean() ? moments[0] : shownMoment();
  for (const row of moment?.rows ?? [])
    for (const probe of row.frame.probes ?? []) {
      const id = probe.pixel.join(',');
      if (!pixels.has(id)) pixels.set(id, []);
      pixels.get(id).push({row, probe});
    }
  return pixels;
}

const kLuminance = [0.2126, 0.7152, 0.0722];
function lightOf(value) {
  if (!Array.isArray(value)) return value;
  const channel = $('channel').value;
  return channel === 'mean' ? value.reduce((sum, part, i) => sum + part * kLuminance[i], 0) :
                              value[Number(channel)];
}

const depthMarks = {
  id: 'marks',
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x}} = chart;
    ctx.save();
    ctx.font = `11px ${Chart.defaults.font.family}`;
    let line = 0;
    for (const mark of depthMarksShown) {
      const at = x.getPixelForValue(mark.depth);
      if (!(at >= area.left && at <= area.right)) continue;
      ctx.strokeStyle = ctx.fillStyle = mark.colour;
      ctx.setLineDash(mark.dash);
      ctx.beginPath();
      ctx.moveTo(at, area.top);
      ctx.lineTo(at, area.bottom);
      ctx.stroke();
      const right = at + ctx.measureText(mark.text).width + 8 < area.right;
      ctx.textAlign = right ? 'left' : 'right';
      ctx.fillText(mark.text, at + (right ? 4 : -4), area.top + 12 + 14 * line++);
    }
    ctx.restore();
  },
};

function drawTransmittance() {
  const pixels = probedPixels();
  $('transmittance_section').hidden = !pixels.size;
  document.documentElement.dataset.pixels = pixels.size;
  transmittance?.destroy();
  transmittance = null;
  if (!pixels.size) return;
  const id = pixels.has(view.pixel) ? view.pixel : pixels.keys().next().value;
  $('pixel').replaceChildren(
      ...[...pixels.keys()].map((pixel) => element('option', {value: pixel}, pixel.replace(',', ', '))));
  $('pixel').value = id;
  $('depth').value = view.depth;
  const asked = pixels.get(id);
  const first = asked[0].probe;
  const isColoured = asked.some(({probe}) => [...probe.exact, ...probe.transmittance].some(Array.isArray));
  $('channel_label').hidden = !isColoured;

  const marks = [];
  if (first.opaque_depth_m)
    marks.push({depth: first.opaque_depth_m, text: 'something solid', colour: css('--quiet'), dash: []});
  const solid = first.opaque_depth_m ?? Infinity;  // behind it nothing is asked of a method
  const points = (probe, values) =>
      probe.depth_m.map((depth, i) => ({x: depth, y: lightOf(values[i])})).filter(({x}) => x <= solid);
  const dashes = [[], [6, 3], [2, 3], [9, 3, 2, 3]];
  const datasets = [{
    label: 'exact',
    data: points(first, first.exact),
    borderColor: css('--exact'),
    borderWidth: 7,
    pointRadius: 0,
    stepped: 'middle',
    order: 1
  }];
  const known = asked.filter(({row, probe}) => row.method !== 'reference' && probe.transmittance.length);
  const curves =
      known.length > 8 ? known.filter(({row}) => row.settings === '' || row.id === view.method) : known;
  curves.forEach(({row, probe}, i) => {
    const {colour} = symbolOf(row.method);
    datasets.push({
      label: row.id,
      data: points(probe, probe.transmittance),
      borderColor: colour,
      borderWidth: 1.8,
      pointRadius: 0,
      pointHitRadius: 6,
      borderDash: dashes[Math.floor(i / 2) % 4]
    });
    if (probe.zero_depth_m)
      marks.push({depth: probe.zero_depth_m, text: `${row.id} draws nothing behind`, colour, dash: [3, 3]});
  });
  const beyond = datasets.filter(({data}) => data.some(({y}) => y > kMostLight)).map(({label}) => label);
  $('transmittance_note').textContent =
      `Pixel ${id.replace(',', ', ')} of ${
          asked[0].row.moment.name}. Click a name to hide or show its curve.` +
      (curves.length < known.length ?
           ' Methods with their defaults are here, and the one whose pictures are shown.' :
           '') +
      (beyond.length ?
           ` Above 1 is not drawn: ${beyond.join(', ')} knows no transmittance but weighs each thing by a guess, which may be above 1 everywhere.` :
           '');
  depthMarksShown = marks;
  transmittance = new Chart($('transmittance'), {
    type: 'line',
    data: {datasets},
    plugins: [depthMarks],
    options: {
      parsing: false,
      interaction: {mode: 'nearest', intersect: false},
      scales: {
        x: {
          type: view.depth === 'log' ? 'logarithmic' : 'linear',
          min: first.depth_m[0],
          max: Math.min(first.depth_m.at(-1), 1.02 * solid),
          title: {display: true, text: 'depth from the eye, m', color: css('--ink')},
          ticks: {callback: (value) => tickFigure(value), maxRotation: 0, autoSkipPadding: 14},
          grid: {color: css('--faint')}
        },
        y: {
          min: 0,
          max: kMostLight,
          title: {display: true, text: 'light from behind that comes through', color: css('--ink')},
          grid: {color: css('--faint')}
        },
      },
      plugins: {
        legend: {
          display: true,
          labels: {
            sort: (a, b) => (a.text !== 'exact') - (b.text !== 'exact'),
            boxWidth: 28,
            boxHeight: 0,
            color: css('--ink')
          }
        },
        tooltip: {
          callbacks: {
            title: (items) => `${figure(items[0].parsed.x)} m`,
            label: (item) => `${item.dataset.label}: ${figure(item.parsed.y)}`
          }
        },
      },
    },
  });
}

function makeTransmittance() {
  $('pixel').addEventListener('change', () => change({pixel: $('pixel').value}));
  $('depth').addEventListener('change', () => change({depth: $('depth').value}));
  $('channel').addEventListener('change', drawTransmittance);
}

drawers.push((changed) => {
  if (!changed.size || ['moment', 'pixel', 'depth', 'method'].some((name) => changed.has(name)))
    drawTransmittance();
});
