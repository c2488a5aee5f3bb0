package org.selectiverenderer.app.window;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import org.selectiverenderer.study.questionnaire.PictureFile;

/** Shows a picture, scaled down to fit the available width. */
final class ScaledPicture extends JComponent {
  private static final long serialVersionUID = 1L;
  private static final int TALLEST = 420;

  private final transient BufferedImage picture;

  /**
   * @param width maximum width in pixels
   * @throws UncheckedIOException if the picture cannot be read
   */
  ScaledPicture(Path file, int width) {
    picture = read(file);
    double scale =
        Math.min(
            1,
            Math.min(width / (double) picture.getWidth(), TALLEST / (double) picture.getHeight()));
    Dimension size =
        new Dimension(
            (int) Math.round(picture.getWidth() * scale),
            (int) Math.round(picture.getHeight() * scale));
    setPreferredSize(size);
    setMinimumSize(size);
    setMaximumSize(size);
    setAlignmentX(0);
  }

  /**
   * Reads a picture.
   *
   * @throws UncheckedIOException if it cannot be read
   */
  static BufferedImage read(Path file) {
    try {
      PictureFile.requireSound(file);
      BufferedImage read = ImageIO.read(file.toFile());
      if (read == null) {
        throw new IOException(file + " is not a picture that can be shown (PNG or JPEG)");
      }
      return read;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D drawing = (Graphics2D) graphics.create();
    drawing.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
    drawing.drawImage(picture, 0, 0, getWidth(), getHeight(), null);
    drawing.dispose();
  }
}
