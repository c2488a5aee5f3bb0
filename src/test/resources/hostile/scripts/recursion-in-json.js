// A list within a list, a hundred thousand deep, as JSON and text.
function initialize() { var a = []; for (var i = 0; i < 1e5; i++) a = [a]; for (;;) { try { JSON.stringify(a); } catch (e) {} try { String(a); } catch (e) {} try { a.flat(Infinity); } catch (e) {} } }
