// An iterator whose return never ends.
function initialize() { var o = {}; o[Symbol.iterator] = () => ({next: () => ({done: false}), return: () => { for (;;); }}); new Map(o); }
