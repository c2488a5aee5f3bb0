// The longest array there is, filled.
function initialize() { new Array(4294967295).fill(); }
