// Typed arrays of integers.
function initialize() { new BigInt64Array(8).fill(1); }
