// A thenable that resolves with itself anew.
var t = {then: function (r) { r({then: t.then}); }};
function initialize() { Promise.resolve(t); }
