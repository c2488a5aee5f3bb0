// An array made from something with 2147483648 elements.
function initialize() { Array.from({length: 2147483648}); }
