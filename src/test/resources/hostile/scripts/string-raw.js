// String.raw of something with two billion parts.
function initialize() { String.raw({raw: {length: 2147483647}}); }
