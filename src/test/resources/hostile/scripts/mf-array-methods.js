// The methods of lists on MF arrays.
function initialize() { var a = new MFFloat(); a.length = 1e6; for (;;) { a.toString(); a.map(x => x); a.join(); } }
