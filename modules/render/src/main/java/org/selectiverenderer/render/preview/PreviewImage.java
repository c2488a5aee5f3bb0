package org.selectiverenderer.render.preview;

import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.Screenshot;

/**
 * A preview picture with its boxes and mask.
 *
 * @param pixels the picture, whose alpha channel is the mask of {@link PreviewOptions}
 * @param camera the camera that it was taken with
 * @param drawn the counts of what the picture shows, without the boxes
 * @param samples the samples per pixel that it was asked for with; 0 for no anti-aliasing
 */
public record PreviewImage(Screenshot pixels, Camera camera, FrameStatistics drawn, int samples) {}
