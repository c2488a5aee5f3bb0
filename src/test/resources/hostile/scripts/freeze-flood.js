// A list of a million elements, frozen and copied.
function initialize() { var a = new Array(1e6).fill(1); for (;;) { Object.freeze(a.slice()); Object.entries(a); Object.assign({}, a); } }
