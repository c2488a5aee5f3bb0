// A text of 2 MB sought in one of 4 MB that is nearly all like it.
var a = 'a'.repeat(1 << 22), b = 'a'.repeat(1 << 21) + 'b';
function initialize() { a.indexOf(b); }
