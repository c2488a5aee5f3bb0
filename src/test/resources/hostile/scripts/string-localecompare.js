// Texts of many MB compared by the rules of a language.
function initialize() { for (;;) 'a\u0301'.repeat(1e6).localeCompare('\u00e1'.repeat(2e6)); }
