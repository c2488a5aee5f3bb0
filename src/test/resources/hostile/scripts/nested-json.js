// A list of twice the same list, 60 deep, as JSON.
var a = [1];
for (var i = 0; i < 60; i++) a = [a, a];
function initialize() { JSON.stringify(a); }
