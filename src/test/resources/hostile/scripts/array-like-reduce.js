// Array's reduce on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.reduce.call({length: '9007199254740991'}, (p, q) => p); }
