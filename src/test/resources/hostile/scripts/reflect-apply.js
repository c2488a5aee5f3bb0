// Reflect.apply with two billion arguments.
function initialize() { Reflect.apply(Math.max, null, {length: 2147483647}); }
