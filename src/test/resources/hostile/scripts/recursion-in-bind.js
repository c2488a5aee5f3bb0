// A function bound a hundred thousand times.
function initialize() { var f = function () {}; for (var i = 0; i < 1e5; i++) f = f.bind(null); f(); }
