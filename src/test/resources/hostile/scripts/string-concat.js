// Texts concatenated to two billion characters.
function initialize() { var s = 'x'; for (;;) s = s.concat(s, s, s); }
