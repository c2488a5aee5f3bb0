// Text of a list of two billion characters.
function initialize() { String.fromCharCode.apply(null, {length: 2147483647}); }
