// An object whose text is made of its text.
function initialize() { var o = {toString: function () { return '' + o; }}; '' + o; }
