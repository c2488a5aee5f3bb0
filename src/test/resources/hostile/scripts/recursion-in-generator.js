// A generator that delegates to itself.
function initialize() { function* g() { yield* g(); } g().next(); }
