// Padding to two billion characters by short texts.
function initialize() { for (;;) 'x'.padStart(2e7, 'abc').length; }
