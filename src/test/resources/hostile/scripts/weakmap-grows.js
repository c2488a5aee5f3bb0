// A weak map of objects that are kept.
function initialize() { var w = new WeakMap(), k = []; for (;;) { var o = {}; k.push(o); w.set(o, 'x'.repeat(100)); } }
