// The longest array there is, as text.
function initialize() { new Array(4294967295).join('x'); }
