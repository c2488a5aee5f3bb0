// A loop that catches whatever ends it.
function initialize() {
  for (;;) { try { [1].map(function g() { for (;;); }); } catch (e) {} }
}
