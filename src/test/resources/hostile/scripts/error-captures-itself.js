// Errors that become texts by errors.
function initialize() { var e = new Error(); e.toString = () => { throw e; }; for (;;) { try { '' + e; } catch (x) {} } }
