// An expression whose group must come again.
function initialize() { /(.*)(.*)(.*)(.*)(.*)\1\2x/.test('ab'.repeat(1000)); }
