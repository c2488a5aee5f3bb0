// A function that says it has five million parameters.
function initialize() { var f = function () {}; f.length = 5000000; Object.defineProperty(f, 'length', {value: 5000000}); for (;;) { f.bind(null); f(); new f(); f.toString(); } }
