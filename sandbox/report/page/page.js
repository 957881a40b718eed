// Puts the page together once, and draws it anew when the address or the colours of the system change.

function drawHead() {
  const {device, driver, api, threads, ...others} = input.results.environment;
  const environment = {device, driver, Vulkan: api, threads, ...others};
  const sizes = [...new Set(frames.map((frame) => frame.size.join('×')))];
  if (sizes.length) environment['picture'] = listText(sizes);
  const samples =
      [...new Set(frames.flatMap((frame) => frame.passes.slice(0, 1).map((pass) => pass.samples)))];
  if (samples.length) environment['timed'] = `${samples.sort((a, b) => a - b).join(' or ')} times each`;
  const jobs = input.results.plan?.jobs;
  if (jobs > frames.length) environment['jobs'] = `${frames.length} of ${jobs}`;
  for (const [name, value] of Object.entries(environment).filter(([, known]) => known !== undefined))
    $('environment')
        .append(element(
            'div', {}, element('dt', {}, name),
            element('dd', {}, typeof value === 'object' ? JSON.stringify(value) : String(value))));
  const notes = (input.results.notes ?? []).map((note) => note.text ?? String(note));
  $('notes').hidden = !notes.length;
  if (notes.length)
    $('notes').append(
        element('strong', {}, 'Times may be off: '),
        notes.length === 1 ? notes[0] : element('ul', {}, ...notes.map((note) => element('li', {}, note))));
  const command = input.results.command;
  $('again').append(
      ...(command ?
              [
                'The whole run: ', element('code', {}, command), ' ',
                element('button', {type: 'button', onclick: () => copy(command)}, 'copy'), '. '
              ] :
              []),
      'A single row: the button at its end in the table. Pictures and errors come out the same to the last bit on the same device and build; times never quite.');
}

function start() {
  chartDefaults();
  readAddress();
  drawHead();
  makeControls();
  makeSlider();
  makeTransmittance();
  if (!views.length) {
    $('controls').hidden = true;
    for (const section of document.querySelectorAll('main section')) section.hidden = true;
    document.querySelector('main').prepend(
        element('p', {class: 'warning'}, 'Nothing has been measured yet.'));
  } else {
    redraw([]);
  }
  document.documentElement.dataset.ready = 'yes';
}

start();
addEventListener('hashchange', () => {
  readAddress();
  redraw([]);
});
darkScheme.addEventListener('change', () => {
  chartDefaults();
  redraw([]);
});
