// Array's fill on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.fill.call({length: '9007199254740991'}, 0); }
