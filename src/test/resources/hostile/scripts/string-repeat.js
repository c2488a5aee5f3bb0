// A text of two billion characters.
function initialize() { 'x'.repeat(2147483647); }
