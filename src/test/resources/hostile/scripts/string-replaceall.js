// A text of 2 MB replaced in one of 4 MB.
var a = 'a'.repeat(1 << 22), b = 'a'.repeat(1 << 21) + 'b';
function initialize() { for (;;) { a.replace(b, ''); a.replaceAll(b, ''); } }
