// The names of a long text’s characters.
function initialize() { for (;;) Object.getOwnPropertyNames('x'.repeat(1e6)); }
