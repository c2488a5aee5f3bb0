package org.selectiverenderer.runtime.render.mark;

import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.context.Screenshot;

/**
 * A picture with marks.
 *
 * @param pixels alpha is the mask of {@link Marking}
 * @param camera it was taken with
 * @param drawn without the marks
 */
public record MarkedPicture(Screenshot pixels, Camera camera, Drawn drawn) {}
