// JSON of an object that gives another object for each of its parts.
function initialize() { JSON.stringify({a: 1}, function (k, v) { return {a: {}, b: {}}; }); }
