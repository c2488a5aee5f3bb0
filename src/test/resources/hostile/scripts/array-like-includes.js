// Array's includes on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.includes.call({length: '9007199254740991'}, 0); }
