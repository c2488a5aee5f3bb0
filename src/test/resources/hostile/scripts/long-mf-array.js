// MF arrays made longer and longer.
function initialize() { var a = new MFVec3f(); for (;;) a.length = a.length + 1e6; }
