package org.selectiverenderer.openxr;

/**
 * The view of an eye: pose and field of view (XrView).
 *
 * @param pose pose of the eye, in the space in which the view was located
 * @param left tangent of the angle to the left edge of the picture, usually below 0
 * @param right tangent of the angle to the right edge, above {@code left}
 * @param bottom tangent of the angle to the lower edge, usually below 0
 * @param top tangent of the angle to the upper edge, above {@code bottom}
 */
public record XrEyeView(XrPose pose, double left, double right, double bottom, double top) {}
