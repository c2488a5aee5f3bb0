// A program that reads and runs itself.
function initialize() { var s = 'eval(s); eval(s)'; eval(s); }
