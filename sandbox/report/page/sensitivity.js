// What one more step of a setting buys, where `--sensitivity` asked.

function drawSensitivity() {
  const moment = shownMoment();
  const found = (input.results.sensitivity ?? []).filter((step) => isMean() || !moment || (step.scene === moment.rows[0].frame.scene && step.tick === moment.rows[0].frame.tick));
  $("sensitivity_section").hidden = !found.length;
  document.documentElement.dataset.steps = found.length;
  if (!found.length) return;
  const steps = [...found].sort((a, b) => a.method.localeCompare(b.method) || (b.sure === true) - (a.sure === true) ||
      (b.accuracy_per_ms ?? Infinity) - (a.accuracy_per_ms ?? Infinity));
  const body = steps.map((step) => element("tr", {class: step.sure === false ? "unsure" : null},
      element("td", {class: "text"}, symbolElement(step.method), ` ${step.method}`),
      element("td", {class: "text"}, isMean() ? `${step.scene}, tick ${step.tick}` : null),
      element("td", {class: "text"}, step.parameter),
      element("td", {class: "text"}, `${step.from} → ${step.to}`),
      element("td", {}, `${figure(step.error_before)} → ${figure(step.error_after)}`),
      element("td", {}, `${figure(step.ms_before)} → ${figure(step.ms_after)}`),
      element("td", {}, step.accuracy_per_ms === null ? "free" : figure(step.accuracy_per_ms)),
      element("td", {class: "text"}, step.sure === false ? "no: the times may be the same" : "yes")));
  $("sensitivity").replaceChildren(element("div", {class: "scroll plain", tabindex: "0"}, element("table", {},
      element("thead", {}, element("tr", {}, ...["method", isMean() ? "frame" : "", "setting", "change", "RMSE", "ms", "error less per ms", "sure"].map(
          (name, i) => element("th", {scope: "col", class: i < 4 || i === 7 ? "text" : null}, name)))),
      element("tbody", {}, ...body))));
}

drawers.push((changed) => {
  if (!changed.size || changed.has("moment")) drawSensitivity();
});
