// Numbers written with all digits and in all radixes.
function initialize() { for (;;) { (1e308).toString(3); (1e-300).toString(36); (1e21).toFixed(100); (1.1).toPrecision(100); } }
