// Names beside points, where there is room for them.

const boxesMeet = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

/// Labels beside their points, in the first place that is free; those for which there is none are left to the
/// pointer. `points` come in the order in which they deserve one.
function placeLabels(points, area, measure) {
  const taken = points.flatMap(
      ({x, y, from, to}) => [{x: x - 7, y: y - 7, w: 14, h: 14}, {x: from, y: y - 3, w: to - from, h: 6}]);
  const placed = [];
  for (const point of points) {
    const w = measure(point), h = 15;
    const places = [
      [Math.max(point.x + 11, point.to + 5), point.y - h / 2],
      [Math.min(point.x - 11, point.from - 5) - w, point.y - h / 2],
      [point.x - w / 2, point.y - 8 - h],
      [point.x - w / 2, point.y + 8],
      [point.x + 4, point.y - 8 - h],
      [point.x + 4, point.y + 8],
      [point.x - 4 - w, point.y - 8 - h],
      [point.x - 4 - w, point.y + 8],
      ...[0.25, 0.75].flatMap((left) => [[point.x - left * w, point.y - 8 - h], [point.x - left * w, point.y + 8]]),
      [point.to + 5, point.y + 2],
      [point.to + 5, point.y - 2 - h],
      [point.from - 5 - w, point.y + 2],
      [point.from - 5 - w, point.y - 2 - h],
    ];
    const free = places.map(([x, y]) => ({x, y, w, h}))
                     .find(
                         (box) => box.x >= area.left && box.x + w <= area.right && box.y >= area.top &&
                             box.y + h <= area.bottom && !taken.some((other) => boxesMeet(box, other)));
    if (!free) continue;
    taken.push(free);
    placed.push({...free, point});
  }
  return placed;
}
