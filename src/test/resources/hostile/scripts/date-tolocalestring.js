// Dates in the words of languages, again and again.
function initialize() { for (;;) { new Date(-8.64e15).toLocaleString('x-'.repeat(1000)); (1e300).toLocaleString(); } }
