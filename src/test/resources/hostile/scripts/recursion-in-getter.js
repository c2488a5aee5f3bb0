// A getter that reads itself.
function initialize() { var o = {get x() { return this.x + this.x; }}; o.x; }
