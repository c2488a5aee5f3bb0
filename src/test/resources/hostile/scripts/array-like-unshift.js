// Array's unshift on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.unshift.call({length: '9007199254740991'}, 1); }
