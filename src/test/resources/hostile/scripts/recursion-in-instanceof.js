// A prototype chain of a hundred thousand objects, asked again and again.
function initialize() { var o = {}; for (var i = 0; i < 1e5; i++) o = Object.create(o); for (;;) o.nothing; }
