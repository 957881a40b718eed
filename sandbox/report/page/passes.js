// The passes of each method as one bar: what is the same for all of them grey, its own in colours of their
// kind.

let passChart = null;
const kKinds = {
  common: {text: 'the same for every method', light: ['#c3c8ce', '#aeb4bb'], dark: ['#4a5059', '#5b626c']},
  prepass: {text: 'found out before drawing', light: ['#5a9bd4', '#86b8e2'], dark: ['#3d7fbb', '#5c9bd3']},
  draws: {text: 'drawing what is transparent', light: ['#e2894a', '#efab7b'], dark: ['#c86f30', '#de8f57']},
  resolve: {text: 'made into the picture', light: ['#4dab86', '#7cc5a8'], dark: ['#2f8f6b', '#52ad8a']},
};

function kindOf(pass) {
  const known = input.passes[pass];
  return known?.common ? 'common' : kKinds[known?.group] ? known.group : 'draws';
}

/// Of a row, or the means over the rows behind it.
function passTimes(row) {
  const sums = new Map();
  for (const of of row.of ?? [row])
    for (const pass of of .frame.passes)
      sums.set(pass.name, (sums.get(pass.name) ?? 0) + pass.median_ms / (row.of ?? [row]).length);
  return sums;
}

const passNames = {
  id: 'names',
  afterDatasetsDraw(chart) {
    const {ctx} = chart;
    ctx.save();
    ctx.font = `11px ${Chart.defaults.font.family}`;
    ctx.textBaseline = 'middle';
    ctx.textAlign = 'center';
    ctx.fillStyle = darkScheme.matches ? '#fff' : '#111';
    chart.data.datasets.forEach((dataset, i) => {
      chart.getDatasetMeta(i).data.forEach((bar) => {
        const width = bar.x - bar.base;
        if (width > ctx.measureText(dataset.label).width + 8)
          ctx.fillText(dataset.label, (bar.x + bar.base) / 2, bar.y);
      });
    });
    ctx.restore();
  },
};

function drawPasses() {
  const own = view.x === 'own';
  const bars =
      shownMoment().rows.filter((row) => row.drawn && row.frame.passes.length).map((row) => ({
                                                                                     row,
                                                                                     times: passTimes(row)
                                                                                   }));
  for (const bar of bars)
    bar.total =
        [...bar.times].reduce((sum, [name, ms]) => sum + (own && kindOf(name) === 'common' ? 0 : ms), 0);
  bars.sort((a, b) => a.total - b.total);
  passChart?.destroy();
  passChart = null;
  $('passes_section').hidden = !bars.length;
  document.documentElement.dataset.bars = bars.length;
  if (!bars.length) return;
  const names = [...new Set(bars.flatMap((bar) => [...bar.times.keys()]))];
  const kinds = Object.keys(kKinds).filter(
      (kind) => !(own && kind === 'common') && names.some((name) => kindOf(name) === kind));
  $('passes_note').textContent = `Each bar is one ${
                                     isMean() ? 'method, in ms, mean over all frames' :
                                                'frame, in ms'}, cut into its passes; shorter is faster.` +
      (own ? ' What is the same for every method is left out.' :
             ' Grey is the same work for every method, timed anew with each, so that it differs by chance, or where a ' +
                 'method saves some of it; the coloured rest is what a method costs.') +
      ' Two shades of one colour are two passes.';
  $('passes_key')
      .replaceChildren(...kinds.map(
          (kind) => element(
              'li', {}, element('span', {
                class: 'swatch',
                style: `background:${kKinds[kind][darkScheme.matches ? 'dark' : 'light'][0]}`
              }),
              kKinds[kind].text)));

  const datasets = kinds.flatMap(
      (kind) => names.filter((name) => kindOf(name) === kind)
                    .map((name, i) => ({
                           label: name,
                           data: bars.map((bar) => bar.times.get(name) ?? 0),
                           backgroundColor: kKinds[kind][darkScheme.matches ? 'dark' : 'light'][i % 2],
                           borderColor: css('--card'),
                           borderWidth: {right: 0.5},
                           borderSkipped: false,
                           stack: 'passes',
                           kind,
                         })));
  const narrow = innerWidth < 700;
  const cut = (text) => text.length > (narrow ? 16 : 40) ? text.slice(0, narrow ? 15 : 39) + '…' : text;
  $('passes_frame').style.height = `${bars.length * 30 + 80}px`;
  passChart = new Chart($('passes'), {
    type: 'bar',
    data: {labels: bars.map((bar) => cut(bar.row.id)), datasets},
    plugins: [passNames],
    options: {
      indexAxis: 'y',
      datasets: {bar: {categoryPercentage: 0.86, barPercentage: 0.95}},
      onClick: (event, hit) => {
        if (hit.length) change({method: bars[hit[0].index].row.id});
      },
      interaction: {mode: 'nearest', intersect: true},
      scales: {
        x: {
          stacked: true,
          title: {display: true, text: '← faster      ms on the device', color: css('--ink')},
          grid: {color: css('--faint')}
        },
        y: {stacked: true, ticks: {autoSkip: false, color: css('--ink')}, grid: {display: false}},
      },
      plugins: {
        tooltip: {
          callbacks: {
            title: (items) => bars[items[0].dataIndex].row.id,
            label: (item) =>
                [`${item.dataset.label}: ${figure(item.raw)} ms, ${
                     figure(100 * item.raw / bars[item.dataIndex].total)} % of ${
                     figure(bars[item.dataIndex].total)} ms`,
                 kKinds[item.dataset.kind].text],
          },
        },
      },
    },
  });
}

drawers.push((changed) => {
  if (!changed.size || changed.has('x') || changed.has('moment')) drawPasses();
});
