// What is shown, kept in the address, so that a view can be shared:
// report.html#y=flip&x=own&moment=street@400.

const kNames = {
  y: Object.keys(kErrors),
  x: Object.keys(kTimes)
};
const view = {};
const drawers = [];  // called after every change, with the names of what changed

function readAddress() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const among = (name, allowed) => allowed.includes(asked.get(name)) ? asked.get(name) : allowed[0];
  view.y = among('y', kNames.y);
  view.x = among('x', kNames.x);
  view.moment = among('moment', views.map((moment) => moment.id));
  view.sort = asked.get('sort') ?? '';
  view.down = asked.get('down') === '1';
  view.method = asked.get('method') ?? '';
  view.against = asked.get('against') ?? '';
  view.pixel = asked.get('pixel') ?? '';
  view.depth = among('depth', ['log', 'linear']);
}

function writeAddress() {
  const words = new URLSearchParams();
  for (const [name, value] of Object.entries(view))
    if (value !== '' && value !== false) words.set(name, value === true ? '1' : value);
  history.replaceState(null, '', '#' + words.toString().replaceAll('%40', '@'));
}

function change(changes) {
  const before = {...view};
  Object.assign(view, changes);
  writeAddress();
  redraw(Object.keys(view).filter((name) => view[name] !== before[name]));
}

function redraw(changed) {
  for (const draw of drawers) draw(new Set(changed));
}

const shownMoment = () => views.find((moment) => moment.id === view.moment);
const momentOfId = (id) => views.find((moment) => moment.id === id);
const isMean = () => shownMoment() === all;
const timeUnit = () => shownMoment().unit;

/// "78.1 ms", or "1.29×" of the baseline.
const timeText = (value) => timeUnit() === '×' ? `${figure(value)}×` : `${figure(value)} ms`;
const rangeText = (range) => range ? `[${figure(range[0])}–${figure(range[1])}]` : '';

function makeControls() {
  const select = $('moment');
  for (const moment of views) select.append(element('option', {value: moment.id}, moment.name));
  select.addEventListener('change', () => change({moment: select.value, method: '', against: '', pixel: ''}));
  if (views.length < 2) select.parentElement.hidden = views.length === 0;
  const buttons = [];
  for (const [name, choices] of [['y', kErrors], ['x', kTimes]])
    for (const [id, choice] of Object.entries(choices)) {
      const button = element('button', {type: 'button', onclick: () => change({[name]: id})}, choice.name);
      $(name).append(button);
      buttons.push([name, id, button]);
    }
  drawers.push(() => {
    select.value = view.moment;
    for (const [name, id, button] of buttons) button.setAttribute('aria-pressed', view[name] === id);
  });
}
