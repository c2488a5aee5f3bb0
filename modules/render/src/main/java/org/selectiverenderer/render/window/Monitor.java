package org.selectiverenderer.render.window;

/**
 * A monitor that a window can fill.
 *
 * @param screen the screen of the window system that it belongs to: 0, except where an X server has
 *     several separate screens ({@code :0.0}, {@code :0.1})
 * @param id its identifier on that screen
 * @param x its left edge on the screen, in the desktop's units
 * @param y its upper edge on the screen
 */
public record Monitor(int screen, int id, String name, int x, int y, int width, int height) {
  @Override
  public String toString() {
    return "%dx%d at %d,%d%s%s"
        .formatted(
            width,
            height,
            x,
            y,
            name.isEmpty() ? "" : " (" + name + ")",
            screen == 0 ? "" : " of X screen " + screen);
  }
}
