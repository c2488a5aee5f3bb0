// Sorting by a function that sorts.
function initialize() { var f = () => [2, 1].sort(f); f(); }
