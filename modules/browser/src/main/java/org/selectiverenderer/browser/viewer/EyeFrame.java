package org.selectiverenderer.browser.viewer;

import org.joml.Matrix4dc;

/**
 * The view of one eye of a stereo display, relative to the viewer. The matrices must not be changed
 * after construction.
 *
 * @param toEye the matrix from the viewer's frame to the eye's
 * @param projection the matrix from the eye's frame to clip coordinates
 * @param width the width of the eye's picture in desktop pixels
 * @param height the height of the eye's picture in desktop pixels
 */
public record EyeFrame(Matrix4dc toEye, Matrix4dc projection, double width, double height) {}
