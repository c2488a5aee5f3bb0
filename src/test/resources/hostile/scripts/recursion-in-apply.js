// A function that applies itself.
function initialize() { function f() { return f.apply(this, arguments); } f(1); }
