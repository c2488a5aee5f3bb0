// Names looked up in a proxy.
function initialize() { with (new Proxy({}, {has: () => { for (;;); }})) { x; } }
