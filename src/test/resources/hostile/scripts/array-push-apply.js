// An array that is pushed into itself.
function initialize() { var a = [1]; for (;;) Array.prototype.push.apply(a, a); }
