// A text of 4 MB split at one of 2 MB.
var a = 'a'.repeat(1 << 22), b = 'a'.repeat(1 << 21) + 'b';
function initialize() { a.split(b); }
