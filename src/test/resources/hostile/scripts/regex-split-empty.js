// A long text split into its characters, again and again.
function initialize() { for (;;) 'x'.repeat(1e6).split(/(?:)/); }
