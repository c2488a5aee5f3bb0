package org.selectiverenderer.app.session;

import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;

/**
 * A rectangle of a panel that can be chosen by pointing at it.
 *
 * @param x left side
 * @param y upper side
 * @param choose executed when the target is chosen
 */
record PointerTarget(double x, double y, double width, double height, Runnable choose) {
  private static final int LIGHT = 0x30FFFFFF;

  boolean has(double pointX, double pointY) {
    return pointX >= x && pointX <= x + width && pointY >= y && pointY <= y + height;
  }

  /** Returns the highlight that is drawn over the target while it is pointed at. */
  List<Primitive2D> lit() {
    return List.of(
        Primitive2D.rectangle(x, y, width, height, LIGHT),
        new Primitive2D.Line(x, y, x + width, y, 4, PanelCanvas.INK),
        new Primitive2D.Line(x, y + height, x + width, y + height, 4, PanelCanvas.INK),
        new Primitive2D.Line(x, y, x, y + height, 4, PanelCanvas.INK),
        new Primitive2D.Line(x + width, y, x + width, y + height, 4, PanelCanvas.INK));
  }
}
