// Promises that make promises, from the first statements on.
var f = () => Promise.resolve().then(f);
f();
