// An object with ever more properties.
function initialize() { var o = {}; for (var i = 0;; i++) Object.defineProperty(o, 'p' + i, {get: () => i}); }
