// unescape of 536,870,912 characters.
function initialize() {
  var s = '1';
  for (var i = 0; i < 29; i++) s += s;
  unescape(s);
}
