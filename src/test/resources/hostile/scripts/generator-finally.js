// A generator whose finally begins again.
function initialize() {
  function* g() { for (;;) try { yield 1; } finally { for (;;) try { for (;;); } finally { continue; } } }
  var i = g();
  i.next();
  i.return(1);
}
