// Errors whose stacks are read.
function initialize() { function f(n) { if (n) f(n - 1); else for (;;) new Error('x').stack; } f(400); }
