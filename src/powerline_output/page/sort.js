/* SPDX-FileCopyrightText: 2026 the linelet authors */
/* SPDX-License-Identifier: BSD-3-Clause */
/* A click on the head of a column sorts its table, another one the other way round. */
document.addEventListener('click', function (event) {
  var head = event.target.closest('th');
  if (!head) return;
  var table = head.closest('table'), body = table.tBodies[0];
  var column = Array.prototype.indexOf.call(head.parentNode.children, head);
  var up = head.getAttribute('aria-sort') !== 'ascending';
  Array.prototype.forEach.call(head.parentNode.children, function (other) {
    other.removeAttribute('aria-sort');
  });
  head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  var severities = {none: 0, low: 1, medium: 2, high: 3};
  function value(row) {
    var text = row.cells[column].textContent.trim();
    if (text in severities) return severities[text];
    var number = parseFloat(text);
    return text !== '' && isFinite(number) ? number : text;
  }
  function compare(a, b) {
    var x = value(a), y = value(b);
    var numbers = (typeof x === 'number') - (typeof y === 'number');
    if (numbers !== 0) return -numbers;
    return typeof x === 'number' ? x - y : x.localeCompare(y);
  }
  Array.prototype.slice.call(body.rows)
      .sort(function (a, b) { return up ? compare(a, b) : compare(b, a); })
      .forEach(function (row) { body.appendChild(row); });
});
