// A promise whose reactions loop, in the hope that their end is caught as a rejection.
function initialize() {
  Promise.resolve().then(() => { for (;;); }).catch(() => { for (;;); }).finally(() => { for (;;); });
}
