// An expression with a million groups within each other.
function initialize() { for (;;) { try { new RegExp('('.repeat(1e6)); } catch (e) {} } }
