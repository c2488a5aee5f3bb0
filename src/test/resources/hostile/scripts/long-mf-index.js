// An element of an MF array far away.
function initialize() { numbers[2147483646] = 1; }
