// Array's some on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.some.call({length: '9007199254740991'}, x => false); }
