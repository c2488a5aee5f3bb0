// A text that is added to itself and read each time.
function initialize() { var s = 'xy'; for (;;) { s += s; s.charCodeAt(1); } }
