package org.selectiverenderer.render.display;

import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;

/**
 * The page that the operator's window shows: the participant's picture at a place, and flat
 * graphics around it.
 *
 * @param x the left edge of the picture in pixels
 * @param y the top edge of the picture in pixels, from the top of the window
 * @param width of the picture; 0 for no picture
 * @param height of the picture
 * @param marks the flat graphics, drawn over everything
 */
public record OperatorPage(int x, int y, int width, int height, List<Primitive2D> marks) {
  public OperatorPage {
    marks = List.copyOf(marks);
  }
}
