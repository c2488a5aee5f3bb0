// A function that maps a list by itself.
var f = () => [1].map(f);
function initialize() { f(); }
