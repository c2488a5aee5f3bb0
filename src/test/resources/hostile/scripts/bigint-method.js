// An integer of any length in a method with super, in eval.
function initialize() { eval('({m(){ super.x; return 2n ** 100000000n }})').m(); }
