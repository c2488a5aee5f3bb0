// An expression whose lastIndex goes back.
function initialize() { var r = /x/g; while (r.exec('x')) r.lastIndex = 0; }
