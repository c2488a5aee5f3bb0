// An integer of any length in base 16.
function initialize() { eval("0xfn ** 100000000n"); }
