// A generator without end, spread.
function initialize() { function* g() { for (;;) yield 1; } [...g()]; }
