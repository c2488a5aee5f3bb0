// A setter that sets itself.
function initialize() { var o = {set x(v) { this.x = v; }}; o.x = 1; }
