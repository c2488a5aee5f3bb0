// An MFImage of many images, read one by one.
function initialize() { var a = new MFImage(); a.length = 20000; images = a; for (;;) for (var i = 0; i < 20000; i++) new MFImage(a[i], a[i]); }
