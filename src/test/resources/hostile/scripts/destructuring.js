// Destructuring of an iterator without end.
function initialize() { var o = {}; o[Symbol.iterator] = () => ({next: () => ({done: false, value: o})}); var [...rest] = o; }
