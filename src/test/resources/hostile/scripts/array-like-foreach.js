// Array's forEach on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.forEach.call({length: '9007199254740991'}, x => x); }
