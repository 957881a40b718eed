// Whatever goes wrong in this page is said at its top, and counted for tests.
'use strict';
let pageErrors = 0;
function tellError(text) {
  pageErrors += 1;
  document.documentElement.dataset.errors = pageErrors;
  const place = document.getElementById('page_errors');
  place.hidden = false;
  place.append(`This page has a fault: ${text} `);
}
document.documentElement.dataset.errors = 0;
window.addEventListener('error', (event) => tellError(event.message));
window.addEventListener('unhandledrejection', (event) => tellError(String(event.reason)));
