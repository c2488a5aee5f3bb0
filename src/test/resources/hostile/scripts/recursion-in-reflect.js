// A function that constructs itself by Reflect.
function initialize() { function F() { Reflect.construct(F, []); } new F(); }
