// What moving one setting of a method by a step does to its error and its time, where `--sensitivity` asked.

const kGains = {
  free: () => 'more accurate and no slower',
  buys: (step) => `${figure(step.accuracy_per_ms)} less error for each ms more`,
  saves: (step) => step.accuracy_per_ms ? `${figure(step.accuracy_per_ms)} more error for each ms less` :
                                          'faster, no less accurate',
};

/// In the order of the results, which is the best first.
function stepRow(step) {
  const gain = kGains[step.kind] ?? (step.accuracy_per_ms > 0 ? kGains.buys : () => '');
  return element(
      'tr', {class: step.sure === false ? 'unsure' : null},
      element('td', {class: 'text'}, symbolElement(step.method), ` ${step.method}`),
      isMean() ? element('td', {class: 'text'}, `${step.scene}, tick ${step.tick}`) : null,
      element('td', {class: 'text'}, step.parameter),
      element('td', {class: 'text'}, `${step.from} → ${step.to}`),
      element('td', {}, `${figure(step.error_before ?? Infinity)} → ${figure(step.error_after ?? Infinity)}`),
      element('td', {}, `${figure(step.ms_before)} → ${figure(step.ms_after)}`),
      element('td', {class: 'text'}, gain(step)),
      element('td', {class: 'text'}, step.sure === false ? 'may be chance' : 'yes'));
}

function drawSensitivity() {
  const moment = shownMoment();
  const steps = (input.results.sensitivity ??
                 []).filter((step) => isMean() || !moment || isOf(step, moment.rows[0].frame));
  $('sensitivity_section').hidden = !steps.length;
  document.documentElement.dataset.steps = steps.length;
  if (!steps.length) return;
  const idle = (step) => step.kind === 'worse' || step.kind === 'nothing';
  const heads = [
    'method', ...(isMean() ? ['frame'] : []), 'setting', 'change', 'RMSE', 'transparency alone, ms',
    'what it gains', 'sure'
  ];
  const isNumber = (name) => name === 'RMSE' || name.endsWith('ms');
  const name = (step) => `${step.method} ${step.parameter}=${step.to}`;
  const idleText = (kind, text) => {
    const of = [...new Set(steps.filter((step) => step.kind === kind).map(name))];
    return of.length ? element('p', {class: 'fine'}, `${text}: ${of.join(', ')}.`) : '';
  };
  $('sensitivity')
      .replaceChildren(
          element(
              'div', {class: 'scroll plain', tabindex: '0'},
              element(
                  'table', {},
                  element(
                      'thead', {},
                      element(
                          'tr', {},
                          ...heads.map(
                              (head) => element(
                                  'th', {scope: 'col', class: isNumber(head) ? null : 'text'}, head)))),
                  element('tbody', {}, ...steps.filter((step) => !idle(step)).map(stepRow)))),
          idleText('worse', 'Neither faster nor more accurate'),
          idleText('nothing', 'No difference that can be told'));
}

drawers.push((changed) => {
  if (!changed.size || changed.has('moment')) drawSensitivity();
});
