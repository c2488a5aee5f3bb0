// An iterator that never says it is done.
function initialize() { var o = {}; o[Symbol.iterator] = () => ({next: () => ({done: false})}); [...o]; }
