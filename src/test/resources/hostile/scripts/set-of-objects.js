// A set that keeps what it is given, without end.
function initialize() { var s = new Set(); for (;;) s.add([1, 2, 3]); }
