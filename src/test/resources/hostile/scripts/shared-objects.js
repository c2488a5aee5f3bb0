// The objects of all scripts, spoilt.
function initialize() { Array.prototype.push = () => { for (;;); }; Object.prototype.toString = () => { for (;;); }; String.prototype.split = null; for (;;) [].push(1); }
