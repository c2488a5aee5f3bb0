// An expression with a class of very many characters, made anew.
function initialize() { for (;;) new RegExp('[' + 'a-\uffff'.repeat(1e4) + ']', 'i').test('b'); }
