// A list with one element far away, into an MF field.
function initialize() { var a = []; a[4000000000] = 1; numbers = a; }
