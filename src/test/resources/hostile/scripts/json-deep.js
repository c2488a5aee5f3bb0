// JSON with a million brackets.
function initialize() { for (;;) { try { JSON.parse('['.repeat(1e6)); } catch (e) {} } }
