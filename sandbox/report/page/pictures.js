// Pictures of a method beside those of another, and where they differ. A picture is decoded when it is shown.

function pictureUrl(file) {
  const place = file && document.querySelector(`script[data-picture="${CSS.escape(file)}"]`);
  return place ? `data:image/${input.pictures.format};base64,${place.textContent}` : null;
}

/// Rows with a picture in the moment that is shown; of the mean, in the first moment.
function picturedRows() {
  const moment = isMean() ? moments[0] : shownMoment();
  return moment ? moment.rows.filter((row) => row.drawn && row.frame.image && pictureUrl(row.frame.image)) :
                  [];
}

function setPicture(image, row, file, text) {
  const url = row && pictureUrl(row.frame[file]);
  image.hidden = !url;
  if (url) {
    image.src = url;
    image.alt = text;
  } else {
    image.removeAttribute('src');
  }
}

function drawPictures() {
  const pictured = picturedRows();
  const wanted = (isMean() ? moments[0] : shownMoment())?.rows.some((row) => row.drawn && row.frame.image);
  $('pictures_section').hidden = !wanted;
  $('pictured').hidden = !pictured.length;
  $('no_pictures').hidden = pictured.length > 0;
  if (!pictured.length) return;
  const exact = pictured.find((row) => row.method === 'reference');
  const shown = pictured.find((row) => row.id === view.method) ??
      pictured.find((row) => row.method === 'avboit') ?? pictured.find((row) => row !== exact) ?? pictured[0];
  const against = pictured.find((row) => row.id === view.against) ?? exact ??
      pictured.find((row) => row !== shown) ?? shown;
  const fill = (select, row) => {
    select.replaceChildren(...pictured.map((other) => element('option', {value: other.id}, other.id)));
    select.value = row.id;
  };
  fill($('shown'), shown);
  fill($('against'), against);
  setPicture($('picture_shown'), shown, 'image', `${shown.id}, ${shown.moment.name}`);
  setPicture($('picture_against'), against, 'image', `${against.id}, ${against.moment.name}`);
  setPicture($('error_map'), shown, 'error_map', `error of ${shown.id}`);
  $('side_shown').textContent = shown.id;
  $('side_against').textContent = against.id;
  $('slider_caption').textContent = `${shown.moment.name}. Move the pointer over the picture: ${
                                        shown.id} is left of the line, ${against.id} right of it.` +
      (exact ?
           '' :
           ' The exact picture is not among the results: add the method reference to the comparison to have it here.');
  const map = shown.frame.error_map;
  $('map_frame').hidden = !pictureUrl(map);
  $('map_caption').textContent = map && !pictureUrl(map) ?
      `The map of where it differs had no room in this page: ${map}, beside results.json, is it.` :
      map ?
      `FLIP against the exact reference, on the same scale everywhere: black is no difference, pale yellow another picture. Mean ${
          figure(shown.errors?.flip)}` +
          (shown.frame.error ?
               `; largest difference in light, ${figure(shown.frame.error.max ?? Infinity)}, at pixel ${
                   shown.frame.error.max_at.join(', ')}.` :
               '.') :
      'No error map was written.';
  const method = input.methods[shown.method];
  $('method_note')
      .replaceChildren(
          ...(method ?
                  [
                    element('strong', {}, `${shown.method}: ${method.title}.`),
                    ` ${method.source}. Known limits: ${method.limits}.`,
                    ...(shown.frame.shortfalls ?? []).map((lack) => element('div', {}, ...prose(lack))),
                  ] :
                  []));
  $('thumbnails')
      .replaceChildren(...pictured.map(
          (row) => element(
              'button', {
                type: 'button',
                'aria-pressed': row === shown,
                onclick: () => change({method: row.id}),
              },
              thumbnail(row), element('span', {}, symbolElement(row.method), ` ${row.id}`))));
  document.documentElement.dataset.shown = `${shown.id} | ${against.id}`;
}

/// Decoded when it comes into view.
const seen = new IntersectionObserver((entries) => {
  for (const entry of entries)
    if (entry.isIntersecting) {
      entry.target.src = pictureUrl(entry.target.dataset.file);
      seen.unobserve(entry.target);
    }
}, {rootMargin: '300px'});

function thumbnail(row) {
  const image = element('img', {alt: '', 'data-file': row.frame.image});
  seen.observe(image);
  return image;
}

function makeSlider() {
  const slider = $('slider');
  const move = (percent) => {
    const stage = slider.firstElementChild;
    slider.style.setProperty('--split', `${percent}%`);
    slider.style.setProperty('--at', `${percent / 100 * stage.clientWidth}px`);
    $('divider').style.height = `${stage.clientHeight}px`;
    $('split').value = percent;
  };
  slider.addEventListener('pointermove', (event) => {
    const stage = slider.firstElementChild.getBoundingClientRect();
    move(Math.min(100, Math.max(0, 100 * (event.clientX - stage.left) / stage.width)));
  });
  $('split').addEventListener('input', () => move(Number($('split').value)));
  $('shown').addEventListener('change', () => change({method: $('shown').value}));
  $('against').addEventListener('change', () => change({against: $('against').value}));
  const boxes = [...document.querySelectorAll('.slider')];
  $('zoom').addEventListener('change', () => {
    const zoom = Number($('zoom').value);
    for (const box of boxes) {
      box.style.setProperty('--zoom', zoom);
      box.style.maxHeight = zoom > 1 ? `${box.clientWidth * 9 / 16}px` : '';
    }
    fit();
  });
  for (const box of boxes)  // both pictures show the same place
    box.addEventListener('scroll', () => boxes.filter((other) => other !== box).forEach((other) => {
      if (other.scrollLeft !== box.scrollLeft) other.scrollLeft = box.scrollLeft;
      if (other.scrollTop !== box.scrollTop) other.scrollTop = box.scrollTop;
    }));
  const images = [...document.querySelectorAll('.stage img')];
  const fit = () => {  // pixels that are seen one by one stay squares
    for (const image of images)
      image.style.setProperty(
          '--rendering', image.clientWidth >= 2 * image.naturalWidth ? 'pixelated' : 'auto');
    move(Number($('split').value));
  };
  for (const image of images) image.addEventListener('load', fit);
  addEventListener('resize', fit);
  const {count, bytes, divisor, left_out: leftOut} = input.pictures;
  $('pictures_note').textContent = `${count - leftOut} pictures, ${bytesText(bytes)} of this file.` +
      (divisor > 1 ?
           ` They are shown at 1/${
               divisor} of their width and height and compressed with loss, so that the page stays small; the whole ones are beside results.json.` :
           '') +
      (leftOut ? ` ${leftOut} more had no room and are only beside results.json.` : '');
}

drawers.push((changed) => {
  if (!changed.size || ['moment', 'method', 'against'].some((name) => changed.has(name))) drawPictures();
});
