// An object whose toJSON gives an object like itself.
function initialize() {
  function F() {}
  F.prototype.toJSON = function () { return {a: new F(), b: new F()}; };
  JSON.stringify(new F());
}
