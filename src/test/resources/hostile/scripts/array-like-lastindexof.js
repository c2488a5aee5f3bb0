// Array's lastIndexOf on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.lastIndexOf.call({length: '9007199254740991'}, 0); }
