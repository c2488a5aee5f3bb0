package org.selectiverenderer.runtime.render.show;

import java.util.List;
import org.selectiverenderer.runtime.camera.Mark;

/**
 * What the operator's window shows: the participant's picture somewhere, and marks about it.
 *
 * @param x left of the picture in pixels
 * @param y top of the picture in pixels, from the upper left corner
 * @param width of the picture; 0 for no picture
 * @param height of the picture
 * @param marks drawn over everything
 */
public record OperatorPage(int x, int y, int width, int height, List<Mark> marks) {
  public OperatorPage {
    marks = List.copyOf(marks);
  }
}
