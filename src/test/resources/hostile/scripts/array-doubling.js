// An array that is joined to itself.
function initialize() { var a = [1]; for (;;) a = a.concat(a); }
