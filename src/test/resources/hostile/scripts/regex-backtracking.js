// An expression that tries all ways to divide a text.
function initialize() { /^(a+)+$/.test('a'.repeat(40) + 'b'); }
