// Array's indexOf on something that says it has 9007199254740991 elements.
function initialize() { Array.prototype.indexOf.call({length: '9007199254740991'}, 0); }
