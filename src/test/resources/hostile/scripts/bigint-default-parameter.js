// An integer of any length as a default parameter.
function initialize(a = 2n ** 1000000n) { for (;;) a *= a; }
