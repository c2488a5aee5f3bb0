// A map that grows while it is gone through.
function initialize() { var m = new Map([[0, 0]]); m.forEach((v, k) => m.set(k + 1, 0)); }
