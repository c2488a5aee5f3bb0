// A program of a million nested parentheses.
function initialize() { eval('('.repeat(1e6) + '1' + ')'.repeat(1e6)); for (;;); }
