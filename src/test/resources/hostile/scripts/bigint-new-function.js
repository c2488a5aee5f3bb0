// An integer of any length in a function made of text.
function initialize() { new Function('a = 9n ** 100000000n', 'return a')(); }
