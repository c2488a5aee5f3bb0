// Dates of long texts, read again and again.
function initialize() { for (;;) { Date.parse('1'.repeat(1e6)); Date.parse('(('.repeat(1e5)); new Date(8.64e15).toString(); } }
