// JSON of many levels, each with more spaces before it.
function initialize() {
  var a = [];
  for (var i = 0; i < 3000; i++) a = [a, 1];
  for (;;) JSON.stringify(a, null, 10);
}
