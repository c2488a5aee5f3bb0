// A proxy that has every index.
function initialize() { var p = new Proxy([], {get: (t, k) => k === 'length' ? 9007199254740991 : 1, has: () => true}); Array.prototype.forEach.call(p, () => {}); }
