// A function with a million parameters.
function initialize() { for (;;) new Function('a'.repeat(1e6).split('').map((x, i) => x + i).join(), '')(); }
