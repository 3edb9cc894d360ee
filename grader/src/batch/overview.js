'use strict';
(() => {
const table = document.querySelector('#students');
const body = table.tBodies[0];

function sortBy(head, column) {
  const down = head.getAttribute('aria-sort') === 'ascending';
  for (const each of table.tHead.querySelectorAll('th'))
    each.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const numeric = head.classList.contains('number');
  const rows = [...body.rows].sort((a, b) =>
      numeric ? Number(key(a)) - Number(key(b)) : key(a).localeCompare(key(b)));
  body.append(...(down ? rows.reverse() : rows));
}

table.tHead.querySelectorAll('th').forEach((head, column) =>
  head.querySelector('button')?.addEventListener('click', () => sortBy(head, column)));

/* Only rows and pictures of students that the text names. */
document.querySelector('#filter').addEventListener('input', event => {
  const text = event.target.value.toLowerCase();
  for (const row of body.rows)
    row.hidden = !row.textContent.toLowerCase().includes(text);
  const shown = new Set([...body.rows].filter(row => !row.hidden).map(row => row.dataset.student));
  for (const figure of document.querySelectorAll('.gallery figure[data-student]'))
    figure.hidden = !shown.has(figure.dataset.student);
});

const choice = document.querySelector('#frame');
function showFrame() {
  for (const gallery of document.querySelectorAll('.gallery'))
    gallery.hidden = gallery.dataset.frame !== choice.value;
}
choice?.addEventListener('change', showFrame);
if (choice)
  showFrame();
})();
