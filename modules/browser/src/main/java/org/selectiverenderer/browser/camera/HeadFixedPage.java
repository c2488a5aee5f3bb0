package org.selectiverenderer.browser.camera;

import java.util.List;

/**
 * A page that moves with the head, such as an instruction or a fixation cross: each eye sees it in
 * the middle of its view, as if it were infinitely far away, as large as fits.
 *
 * @param marks the primitives on the page, in coordinates from its upper left corner, +Y down
 * @param width the page's width
 * @param height the page's height
 */
public record HeadFixedPage(List<Primitive2D> marks, double width, double height) {
  public HeadFixedPage {
    marks = List.copyOf(marks);
  }
}
