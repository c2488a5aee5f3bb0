// A prototype chain that a proxy closes.
function initialize() { var p = new Proxy({}, {getPrototypeOf: function () { return p; }}); Object.create(p) instanceof Array; for (;;) p instanceof Array; }
