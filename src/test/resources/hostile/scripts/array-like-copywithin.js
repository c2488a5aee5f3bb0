// Array's copyWithin on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.copyWithin.call({length: '9007199254740991'}, 0, 5); }
