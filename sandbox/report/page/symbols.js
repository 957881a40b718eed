// A colour and a shape for each method, the same everywhere: no two methods share both. Settings of one
// method share its symbol and have labels.

const kColours = {
  // told apart by people who see few colours, after Okabe and Ito
  light: ['#0072b2', '#d55e00', '#00855f', '#b4478c', '#8a6d00', '#2f8fc4', '#7a4fb5', '#555b63'],
  dark: ['#4aa8e8', '#ff8a4a', '#3fc99b', '#ef8fc8', '#e6c34a', '#8fd0f5', '#b79af0', '#b6bcc4'],
};
const kShapes = ['circle', 'rect', 'triangle', 'rectRot', 'cross', 'crossRot', 'star', 'nabla'];
const kOutlines = {
  circle: 'M7 1.8a5.2 5.2 0 1 0 .01 0z',
  rect: 'M2.5 2.5h9v9h-9z',
  triangle: 'M7 1.5 13 12H1z',
  nabla: 'M7 12.5 1 2h12z',
  rectRot: 'M7 .8 13.2 7 7 13.2 .8 7z',
  cross: 'M7 1v12M1 7h12',
  crossRot: 'M2.5 2.5l9 9M11.5 2.5l-9 9',
  star: 'M7 1v12M1 7h12M2.8 2.8l8.4 8.4M11.2 2.8l-8.4 8.4',
};
const methodOrder = [...new Set(frames.map((frame) => frame.method))];
const darkScheme = matchMedia('(prefers-color-scheme: dark)');

function symbolOf(method) {
  const index = methodOrder.indexOf(method);
  return {
    colour: kColours[darkScheme.matches ? 'dark' : 'light'][index % 8],
    shape: kShapes[(index + Math.floor(index / 8)) % 8],
  };
}
const isOpen = (shape) => ['cross', 'crossRot', 'star'].includes(shape);

function symbolElement(method) {
  const {colour, shape} = symbolOf(method);
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 14 14');
  svg.setAttribute('class', 'symbol');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', kOutlines[shape]);
  path.setAttribute('fill', isOpen(shape) ? 'none' : colour);
  path.setAttribute('stroke', colour);
  path.setAttribute('stroke-width', isOpen(shape) ? 2.4 : 0);
  svg.append(path);
  return svg;
}

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// What all charts have in common. Colours are read anew whenever a chart is made.
function chartDefaults() {
  Chart.defaults.animation = false;
  Chart.defaults.responsive = true;
  Chart.defaults.maintainAspectRatio = false;
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.font.size = 12;
  Chart.defaults.color = css('--quiet');
  Chart.defaults.borderColor = css('--line');
  Chart.defaults.plugins.legend.display = false;
  Object.assign(Chart.defaults.plugins.tooltip, {
    backgroundColor: css('--ink'),
    titleColor: css('--page'),
    bodyColor: css('--page'),
    padding: 10,
    displayColors: false,
    bodySpacing: 3,
  });
}
