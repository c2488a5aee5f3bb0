// Two equal texts of many MB compared again and again.
function initialize() {
  var a = 'x'.repeat(3e7), b = 'x'.repeat(3e7);
  for (;;) { a === b; a < b; a == b; }
}
