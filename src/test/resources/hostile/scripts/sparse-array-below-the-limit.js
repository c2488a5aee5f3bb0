// A list of sixteen million holes, into an MF field.
function initialize() { var a = []; a[16777215] = 1; numbers = a; }
