// An expression with quantifiers of quantifiers.
function initialize() { new RegExp('(?:(?:(?:x{0,60000}){0,60000}){0,60000}){0,60000}y').test('x'.repeat(1e5)); }
