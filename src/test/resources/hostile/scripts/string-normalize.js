// Many MB of characters that fall apart when normalized.
function initialize() { for (;;) '\ufdfa'.repeat(1e6).normalize('NFKD'); }
