// A proxy of a proxy of a proxy, a hundred thousand deep.
function initialize() { var p = {}; for (var i = 0; i < 1e5; i++) p = new Proxy(p, {}); p.x; }
