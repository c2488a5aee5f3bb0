// The names of the longest list.
function initialize() { var a = []; a[4294967294] = 1; for (;;) { for (var k in a) k; Object.keys(a); a.length = 0; a[4294967294] = 1; } }
