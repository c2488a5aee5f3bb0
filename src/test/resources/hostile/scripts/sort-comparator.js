// Sorting by chance, again and again.
function initialize() { var a = []; for (var i = 0; i < 1e5; i++) a.push(i); for (;;) { try { a.sort(() => Math.random() - 0.5); } catch (e) {} } }
