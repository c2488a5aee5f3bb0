// Padding to a length that is another when it is asked again.
function initialize() {
  var asked = 0;
  'x'.padEnd({valueOf: function () { return asked++ ? 2147483647 : 2147483646; }}, 'ab');
}
