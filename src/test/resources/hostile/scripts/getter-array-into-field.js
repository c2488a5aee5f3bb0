// A list whose elements make it longer as they are read, into an MF field.
function initialize() { var a = [1, 2]; Object.defineProperty(a, 0, {get: () => { for (;;); }}); numbers = a; }
