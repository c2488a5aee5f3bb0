// An integer of any length.
function initialize() { (2n ** 100000000n).toString(); }
