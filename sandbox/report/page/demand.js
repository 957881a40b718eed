// Which effects were simulated and why, in the moment that is shown.

function demandTable(moment) {
  const body = moment.demand.instances.map(
      (instance) => element(
          'tr', {}, element('td', {class: 'text'}, instance.name),
          element('td', {class: 'text'}, instance.awake ? '● awake' : '○ asleep'),
          element('td', {class: 'text'}, instance.why), element('td', {}, instance.ticks_simulated),
          element('td', {}, instance.ticks_saved), element('td', {}, instance.dispatches),
          element('td', {}, bytesText(instance.bytes)), element('td', {}, bytesText(instance.bytes_saved))));
  return element(
      'div', {class: 'scroll plain', tabindex: '0'},
      element(
          'table', {}, moments.length > 1 ? element('caption', {}, moment.name) : null,
          element(
              'thead', {},
              element(
                  'tr', {},
                  ...['effect', 'state', 'why', 'ticks simulated', 'ticks saved', 'dispatches', 'memory',
                      'memory saved']
                      .map((name, i) => element('th', {scope: 'col', class: i < 3 ? 'text' : null}, name)))),
          element('tbody', {}, ...body)));
}

function drawDemand() {
  const known = (isMean() ? moments : [shownMoment()]).filter((moment) => moment?.demand?.instances?.length);
  $('demand_section').hidden = !known.length;
  document.documentElement.dataset.awake = known.reduce(
      (sum, moment) => sum + moment.demand.instances.filter((instance) => instance.awake).length, 0);
  const most = 12;
  $('demand_note').textContent =
      'Awake ones were, at this tick and for this view; the others cost next to nothing.' +
      (known.length > most ? ` Shown are the first ${most} frames; choose one above for the others.` : '');
  $('demand').replaceChildren(
      ...known.slice(0, most).flatMap((moment) => [demandTable(moment), element('br')]));
}

drawers.push((changed) => {
  if (!changed.size || changed.has('moment')) drawDemand();
});
