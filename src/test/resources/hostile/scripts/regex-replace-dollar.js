// A replacement that repeats what is before and after each match.
function initialize() { 'x'.repeat(1e5).replace(/x/g, "$`$'"); }
