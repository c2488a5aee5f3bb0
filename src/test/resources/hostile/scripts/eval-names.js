// A program that declares a hundred thousand variables.
function initialize() { for (;;) eval('var ' + 'v'.repeat(1e5).split('').map((x, i) => x + i).join()); }
