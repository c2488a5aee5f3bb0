// An object that gives itself another way each time it is converted.
function initialize() { var o = {}; o[Symbol.toPrimitive] = () => +o; +o; }
