// A function applied to a list of two billion arguments.
function initialize() { Math.max.apply(null, {length: 2147483647}); }
