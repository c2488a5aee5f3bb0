// Keys of a map whose hash codes are all the same.
function initialize() {
  var keys = [''];
  for (var i = 0; i < 17; i++) keys = keys.reduce((l, k) => { l.push(k + 'Aa', k + 'BB'); return l; }, []);
  var m = new Map(), o = {};
  keys.forEach(k => { m.set(k, 1); o[k] = 1; });
  for (;;) keys.forEach(k => { m.get(k); o[k]; });
}
