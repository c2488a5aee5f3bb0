// Numbers of a million digits, read again and again.
function initialize() { var s = '9'.repeat(1e6); for (;;) { Number(s); parseInt(s, 7); parseInt(s, 2); +('0x' + s); } }
