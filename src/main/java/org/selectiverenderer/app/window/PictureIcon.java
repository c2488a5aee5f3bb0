package org.selectiverenderer.app.window;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javax.swing.Icon;

/** A picture as the icon of a button, scaled to fit and centred in a cell of one size. */
final class PictureIcon implements Icon {
  private static final int WIDTH = 190;
  private static final int HEIGHT = 140;

  /** Pixels of the picture that are kept for each of the icon, for a display of double density. */
  private static final int DENSITY = 2;

  private final BufferedImage picture;
  private final int width;
  private final int height;

  /**
   * @throws java.io.UncheckedIOException if the picture cannot be read
   */
  PictureIcon(Path file) {
    BufferedImage read = ScaledPicture.read(file);
    double scale = Math.min(WIDTH / (double) read.getWidth(), HEIGHT / (double) read.getHeight());
    width = Math.max(1, (int) Math.round(scale * read.getWidth()));
    height = Math.max(1, (int) Math.round(scale * read.getHeight()));
    picture = new BufferedImage(DENSITY * width, DENSITY * height, BufferedImage.TYPE_INT_ARGB);
    Graphics2D drawing = picture.createGraphics();
    draw(drawing, read, 0, 0, picture.getWidth(), picture.getHeight());
    drawing.dispose();
  }

  private static void draw(
      Graphics2D drawing, BufferedImage image, int x, int y, int width, int height) {
    drawing.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
    drawing.drawImage(image, x, y, width, height, null);
  }

  @Override
  public void paintIcon(Component on, Graphics graphics, int x, int y) {
    Graphics2D drawing = (Graphics2D) graphics.create();
    draw(drawing, picture, x + (WIDTH - width) / 2, y + (HEIGHT - height) / 2, width, height);
    drawing.dispose();
  }

  @Override
  public int getIconWidth() {
    return WIDTH;
  }

  @Override
  public int getIconHeight() {
    return HEIGHT;
  }
}
