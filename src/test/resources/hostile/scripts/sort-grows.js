// A comparison that makes the list longer.
function initialize() { var a = [3, 1, 2]; a.sort((p, q) => { a.push(1); return p - q; }); for (;;) a.sort((p, q) => { a.length = 4294967295; return 0; }); }
