// Replacing by a function that replaces.
function initialize() { var f = s => 'xx'.replace(/x/g, f); f(); }
