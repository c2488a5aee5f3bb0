// A sum of a million terms.
function initialize() { for (;;) { try { eval('1' + '+1'.repeat(1e6)); } catch (e) {} } }
