// Promises that make promises, each in a job of its own that is short.
var f = () => Promise.resolve().then(f);
function initialize() { f(); }
