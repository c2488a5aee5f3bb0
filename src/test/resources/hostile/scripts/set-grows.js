// A set to which its iteration adds.
function initialize() { var s = new Set([0]); for (var x of s) s.add(x + 1); }
