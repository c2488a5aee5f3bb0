// Array's sort on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.sort.call({length: '9007199254740991'}); }
