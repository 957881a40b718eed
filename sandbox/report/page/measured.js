// What was measured, as the page thinks of it: moments (a scene at a tick), and in each a row per method with
// its settings. The moment "all" has the means over those that every moment has.

const input = JSON.parse($('data').textContent);
const frames = input.results.frames;

const kErrors = {
  rmse: {name: 'RMSE', of: (error) => error.rmse, text: 'RMSE, in linear light'},
  flip: {name: 'FLIP', of: (error) => error.flip, text: 'FLIP, as a person sees it'},
  ssim: {name: '1 − SSIM', of: (error) => 1 - error.ssim, text: '1 − SSIM, structure'},
};
const kTimes = {
  own: {
    name: 'transparency alone',
    of: (frame) => frame.transparency_ms,
    range: (frame) => frame.transparency_ms_interval,
  },
  total: {name: 'whole frame', of: (frame) => frame.gpu_ms, range: (frame) => frame.gpu_ms_interval},
};
const kExactBelow = 1e-6;

function settingsText(settings) {
  return Object.entries(settings).map(([name, value]) => `${name}=${value}`).join(' ');
}

/// What a picture is without: outputs that its method does not write, particles that nothing can be drawn of.
function lacks(frame) {
  const bad = frame.bad_particles?.count;
  return [...frame.left_out, ...(bad ? [`${bad} bad particle${bad > 1 ? 's' : ''}`] : [])];
}

const differs = (of) => new Set(frames.map((frame) => JSON.stringify(of(frame)))).size > 1;
const severalSizes = differs((frame) => frame.size);
const severalSeeds = differs((frame) => frame.seed ?? null);

function momentOf(frame) {
  let id = `${frame.scene}@${frame.tick}`;
  let name = `${frame.scene}, tick ${frame.tick}`;
  if (frame.shot) [id, name] = [`${id}.shot${frame.shot}`, `shot ${frame.shot}: ${name}`];
  if (severalSizes) [id, name] = [`${id}.${frame.size.join('x')}`, `${name}, ${frame.size.join('×')}`];
  if (severalSeeds) [id, name] = [`${id}.seed${frame.seed}`, `${name}, seed ${frame.seed}`];
  return {id, name};
}

const same = (a, b) => JSON.stringify(a ?? null) === JSON.stringify(b ?? null);

/// Whether something that was measured is of the moment of a frame.
function isOf(thing, frame) {
  return thing.scene === frame.scene && thing.tick === frame.tick &&
      ['shot', 'size', 'seed'].every((name) => thing[name] === undefined || same(thing[name], frame[name]));
}

/// Of one moment, from either form of results.json.
function demandOf(frame, isLast) {
  const at = (input.results.moments ?? []).find((moment) => isOf(moment, frame));
  return at?.demand ?? (isLast ? input.results.demand ?? null : null);
}

/// The line that measures the row again.
function commandOf(frame, changed) {
  if (input.results.command && frame.job) return `${input.results.command} --only ${frame.job}`;
  const words = ['plume compare', frame.scene, `--at ${frame.tick}`, `--methods ${frame.method}`];
  for (const [name, value] of Object.entries(changed)) words.push(`--set ${frame.method}.${name}=${value}`);
  words.push(`--size ${frame.size.join('x')}`);
  if (frame.seed !== undefined) words.push(`--seed ${frame.seed}`);
  if (frame.passes.length) words.push(`--frames ${frame.passes[0].samples}`);
  return words.join(' ');
}

const rows = frames.map((frame, index) => {
  const changed = input.changed_settings[index];
  const settings = settingsText(changed);
  return {
    frame,
    index,
    settings,
    id: settings ? `${frame.method} ${settings}` : frame.method,
    method: frame.method,
    drawn: frame.status === 'ok',
    measured: frame.status === 'ok' && frame.error !== null && frame.error.rmse !== null,
    command: commandOf(frame, changed),
    errors:
        frame.error && Object.fromEntries(Object.entries(kErrors).map(([y, of]) => [y, of.of(frame.error)])),
    times: Object.fromEntries(
        Object.entries(kTimes).map(([x, of]) => [x, {value: of.of(frame), range: of.range(frame) ?? null}])),
  };
});

const moments = [];
for (const row of rows) {
  const {id, name} = momentOf(row.frame);
  let moment = moments.find((other) => other.id === id);
  if (!moment) moments.push(moment = {id, name, rows: [], unit: 'ms'});
  moment.rows.push(row);
  row.moment = moment;
}
moments.forEach((moment, index) => {
  moment.demand = demandOf(moment.rows[0].frame, index === moments.length - 1);
});

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const kBaseline = 'sorted';

/// Errors: arithmetic means. Times: geometric means, of the ratio to plain sorted blending in the same moment
/// where every moment has it. Half the widths of the ranges of the logarithms add like independent errors.
function overAll() {
  const inEvery = (id) => moments.every((moment) => moment.rows.some((row) => row.id === id && row.measured));
  const ids = [...new Set(rows.map((row) => row.id))];
  const shared = ids.filter(inEvery);
  const ratio = shared.includes(kBaseline);
  const at = (id) => moments.map((moment) => moment.rows.find((row) => row.id === id && row.measured));
  const baseline = ratio ? at(kBaseline) : null;
  const logRange = (time) => (Math.log(time.range[1]) - Math.log(time.range[0])) / 2;
  const time = (of, x) => {
    const times = of.map((row) => row.times[x]);
    const others = ratio ? baseline.map((row) => row.times[x]) : [];
    const isBaseline = ratio && of[0].id === kBaseline;
    const value =
        Math.exp(mean(times.map((t, i) => Math.log(t.value) - (ratio ? Math.log(others[i].value) : 0))));
    const known = [...times, ...others].every((t) => t.range && t.range[0] > 0);
    if (!known || isBaseline) return {value, range: isBaseline && known ? [1, 1] : null};
    const squares = [...times, ...others].map((t) => logRange(t) ** 2);
    const half = Math.sqrt(squares.reduce((sum, s) => sum + s, 0)) / times.length;
    return {value, range: [value * Math.exp(-half), value * Math.exp(half)]};
  };
  const means = shared.map((id) => {
    const of = at(id);
    return {
      ...of[0],
      of,
      command: null,
      errors: Object.fromEntries(Object.keys(kErrors).map((y) => [y, mean(of.map((row) => row.errors[y]))])),
      psnr: null,
      memory: Math.max(...of.map((row) => row.frame.memory_bytes)),
      times: Object.fromEntries(Object.keys(kTimes).map((x) => [x, time(of, x)])),
    };
  });
  return {
    id: 'all',
    name: `all ${moments.length} frames`,
    rows: means,
    unit: ratio ? '×' : 'ms',
    missing: ids.filter((id) => !inEvery(id) && rows.some((row) => row.id === id && row.measured)),
    demand: null,
  };
}

const all = moments.length > 1 ? overAll() : null;
if (all) all.rows.forEach((row) => row.moment = all);
const views = all && all.rows.length > 1 ? [all, ...moments] : moments;

const errorOf = (row, y) => row.errors[y] < kExactBelow ? 0 : row.errors[y];
const rangesMeet = (a, b) =>
    Boolean(a.range && b.range && a.range[0] <= b.range[1] && b.range[0] <= a.range[1]);
const isFaster = (a, b) => a.value < b.value && !rangesMeet(a, b);

/// Those that nothing beats: nothing is as accurate and surely faster, nor more accurate and no slower.
function paretoFront(measured, x, y) {
  const beats = (a, b) => (errorOf(a, y) <= errorOf(b, y) && isFaster(a.times[x], b.times[x])) ||
      (errorOf(a, y) < errorOf(b, y) && a.times[x].value <= b.times[x].value);
  return measured.filter((row) => !measured.some((other) => beats(other, row)))
      .sort((a, b) => a.times[x].value - b.times[x].value || errorOf(b, y) - errorOf(a, y));
}
