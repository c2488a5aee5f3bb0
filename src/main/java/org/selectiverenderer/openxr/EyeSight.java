package org.selectiverenderer.openxr;

/**
 * What an eye sees, and from where.
 *
 * @param pose of the eye, in the frame that is told with it
 * @param left tangent of the angle to the left side of its picture, usually below 0
 * @param right likewise, above {@code left}
 * @param bottom likewise, usually below 0
 * @param top likewise, above {@code bottom}
 */
public record EyeSight(SpacePose pose, double left, double right, double bottom, double top) {}
