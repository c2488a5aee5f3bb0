// A function with a length of two billion, called and bound.
function f() {}
f.length = 2147483647;
function initialize() { for (;;) { f.call.apply(f, {length: 1e7}); } }
