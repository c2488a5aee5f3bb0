// A text that is added to itself.
function initialize() { var s = 'x'; for (;;) { s += s; s.length; } }
