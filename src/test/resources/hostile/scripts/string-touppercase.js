// Texts that get longer in capitals.
function initialize() { var s = '\u0390'; for (;;) { s += s.toUpperCase(); } }
