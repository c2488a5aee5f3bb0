// A program of a million statements, again and again.
function initialize() { for (;;) eval('x=1;'.repeat(1e5)); }
