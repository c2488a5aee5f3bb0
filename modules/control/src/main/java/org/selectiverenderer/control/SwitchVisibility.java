package org.selectiverenderer.control;

/**
 * This tells what the viewer sees of an object at the moment at which its version changes.
 *
 * @param visible whether some of the object is in the view and not hidden by other objects
 * @param pixels estimated number of the picture's pixels that show the object
 * @param turning rate at which the view turns, in degrees per second
 */
public record SwitchVisibility(boolean visible, double pixels, double turning) {}
