// An array that is spread into itself.
function initialize() { var a = [1]; for (;;) a = [...a, ...a]; }
