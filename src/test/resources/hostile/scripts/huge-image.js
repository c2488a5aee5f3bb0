// An image of two billion pixels.
function initialize() { for (;;) new SFImage(46340, 46340, 4, new MFInt32()).toString(); }
