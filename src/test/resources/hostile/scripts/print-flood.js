// Lines printed without end.
function initialize() { for (;;) print('x'.repeat(1e6)); }
