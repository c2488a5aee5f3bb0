// A loop that only jumps.
function initialize() { a: for (;;) { b: for (;;) continue a; } }
