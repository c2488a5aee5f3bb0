// Scenes written as text again and again.
function initialize() { for (;;) { Browser.currentScene.toXMLString(); Browser.currentScene.toVRMLString(); } }
