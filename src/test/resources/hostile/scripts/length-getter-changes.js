// A length that is small when it is asked first.
function initialize() {
  var asked = 0;
  Array.prototype.indexOf.call({get length() { return asked++ ? 9007199254740991 : 1; }}, 0);
  asked = 0;
  var many = [1];
  many.indexOf = Array.prototype.indexOf;
  Object.defineProperty(many, 0, {get: function () { many.length = 4294967295; return 0; }});
  many.forEach(function () {});
  Array.prototype.reverse.call(many);
}
