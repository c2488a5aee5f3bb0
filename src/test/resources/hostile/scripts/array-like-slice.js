// Array's slice on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.slice.call({length: '9007199254740991'}, 0, 9e15); }
