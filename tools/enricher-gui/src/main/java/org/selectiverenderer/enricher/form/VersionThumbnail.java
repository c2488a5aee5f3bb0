package org.selectiverenderer.enricher.form;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/** The thumbnail of a version; an empty frame until the picture is there. */
final class VersionThumbnail extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int WIDTH = 96;
  private static final int HEIGHT = 72;

  private transient @Nullable BufferedImage image;

  VersionThumbnail(String name) {
    setOpaque(false);
    getAccessibleContext().setAccessibleName(name);
    Dimension size = new Dimension(UIScale.scale(WIDTH), UIScale.scale(HEIGHT));
    setPreferredSize(size);
    setMinimumSize(size);
  }

  /** The size of its picture in device pixels. */
  Dimension pixels() {
    double scale =
        getGraphicsConfiguration() == null
            ? 1
            : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    Dimension size = getPreferredSize();
    return new Dimension(
        (int) Math.round(size.width * scale), (int) Math.round(size.height * scale));
  }

  void show(BufferedImage picture) {
    image = picture;
    repaint();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D g = (Graphics2D) graphics.create();
    if (image == null) {
      g.setColor(UIManager.getColor("Table.gridColor"));
      g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
    } else {
      g.setRenderingHint(
          RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
      g.drawImage(image, 0, 0, getWidth(), getHeight(), null);
    }
    g.dispose();
  }
}
