// Templates with tags that call each other.
function initialize() { var f = s => f`${s}${s}`; f`x`; }
