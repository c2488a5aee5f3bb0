// Symbols of ever new names.
function initialize() { for (var i = 0;; i++) Symbol.for('some longer name of a symbol ' + i); }
