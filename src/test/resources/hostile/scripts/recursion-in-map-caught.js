// A function that maps a list by itself and begins again.
var f = () => { try { return [1].map(f); } catch (e) { return [1].map(f); } };
function initialize() { f(); }
