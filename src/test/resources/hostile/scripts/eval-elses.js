// A program of a hundred thousand branches.
function initialize() { for (;;) { try { eval('if(0);else '.repeat(1e5) + ';'); } catch (e) {} } }
