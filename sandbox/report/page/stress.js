// The matrix of hard cases and methods, and what is known of the cell that is chosen.

const input = JSON.parse($('data').textContent);
const methods = [...new Set(input.rows.map((row) => row.method))];
const cases = [...new Set(input.rows.map((row) => row.case))];
const asText = (value) => value === null ? '∞' : figure(255 * value);

function tell(row, cell) {
  document.querySelector('td.picked')?.classList.remove('picked');
  cell.classList.add('picked');
  const hard = input.cases[row.case];
  $('detail').hidden = false;
  $('detail').replaceChildren(
      element('p', {}, element('strong', {}, `${row.method}, ${hard.title}: ${row.verdict}. `), `${hard.trouble}.`),
      row.verdict === 'unavailable' ?
          '' :
          element(
              'p', {},
              `In the mean ${asText(row.rmse)} of ${asText(row.bound.rmse)}, at most ${asText(row.max)} of ${
                  asText(row.bound.max)}` +
                  (row.picture ? `, in “${row.picture}” at pixel ${row.pixel.join(', ')}.` : '.') +
                  (row.finite ? '' : ' Something drawn is not a number.')),
      row.why ? element('p', {}, `Why: ${row.why}.`) : '');
}

function drawMatrix() {
  const head = element(
      'tr', {}, element('th', {class: 'text', scope: 'col'}, 'case'),
      ...methods.map((method) => element('th', {class: 'method', scope: 'col'}, method)));
  const body = cases.map((id) => element(
      'tr', {}, element('th', {scope: 'row', title: input.cases[id].trouble}, input.cases[id].title),
      ...methods.map((method) => {
        const row = input.rows.find((other) => other.case === id && other.method === method);
        if (!row) return element('td', {});
        const cell = element(
            'td', {class: `cell ${row.verdict.toLowerCase()}`, title: row.why ?? row.verdict, tabindex: '0'},
            row.verdict === 'unavailable' ? '' : asText(row.max));
        cell.addEventListener('click', () => tell(row, cell));
        cell.addEventListener('keydown', (event) => event.key === 'Enter' && tell(row, cell));
        return cell;
      })));
  $('matrix').replaceChildren(element('thead', {}, head), element('tbody', {}, ...body));
}

for (const [name, value] of Object.entries(input.environment))
  $('environment').append(element('div', {}, element('dt', {}, name), element('dd', {}, String(value))));
$('command').textContent = input.command;
drawMatrix();
document.documentElement.dataset.cells = document.querySelectorAll('td.cell').length;
document.documentElement.dataset.failed = document.querySelectorAll('td.failed, td.gone').length;
document.documentElement.dataset.ready = 'yes';
