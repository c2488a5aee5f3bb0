// Nodes made from text, in larger and larger numbers.
function initialize() { for (var n = 1;; n *= 2) Browser.createX3DFromString('<X3D version="4.0" profile="Full"><Scene>' + '<Group/>'.repeat(n) + '</Scene></X3D>'); }
