// A program of a million nested lists, read by eval.
function initialize() { for (;;) { try { eval('['.repeat(1e6)); } catch (e) {} } }
