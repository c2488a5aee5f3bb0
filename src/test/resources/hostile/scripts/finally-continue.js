// A loop that begins again when it is stopped.
function initialize() {
  for (;;) { try { for (;;); } finally { continue; } }
}
