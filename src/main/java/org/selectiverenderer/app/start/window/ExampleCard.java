package org.selectiverenderer.app.start.window;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Objects;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.start.Example;

/** An example: its picture, what it is, and what to do with it. */
final class ExampleCard extends JPanel {
  private static final long serialVersionUID = 1;

  /**
   * @param show shows the example
   * @param enrich opens it in the enricher
   */
  ExampleCard(Example example, Runnable show, Runnable enrich) {
    super(
        new MigLayout("insets 0, fillx, wrap 1, gapy 4", "[grow,fill]", "[][]0[grow,top][bottom]"));
    String name = StartTexts.of(example.key());
    JLabel title = new JLabel(name);
    title.setFont(title.getFont().deriveFont(Font.BOLD));
    add(new Picture(example.key(), name), "growx, wmin 100, wmax 340");
    add(title);
    add(StartTexts.paragraph(StartTexts.of(example.key() + ".about")), "growx, wmin 80");
    JPanel buttons = new JPanel(new MigLayout("insets 0"));
    buttons.add(button("show", example, name, show));
    if (example.enriched()) {
      buttons.add(button("edit", example, name, enrich));
    }
    add(buttons);
  }

  private static JButton button(String key, Example example, String name, Runnable does) {
    JButton button = StartTexts.button(key);
    button.setName(key + "." + example.key());
    button.getAccessibleContext().setAccessibleName(StartTexts.of(key + ".name", name));
    button.addActionListener(event -> does.run());
    return button;
  }

  /** A picture with twice the pixels of its usual size, for screens that have them. */
  private static final class Picture extends JComponent {
    private static final long serialVersionUID = 1;
    private static final int USUAL_WIDTH = 240;
    private static final int LEAST_WIDTH = 100;

    private final transient BufferedImage image;

    Picture(String key, String name) {
      String file = key + ".jpg";
      try (InputStream in = Objects.requireNonNull(Picture.class.getResourceAsStream(file), file)) {
        image = ImageIO.read(in);
      } catch (IOException e) {
        throw new UncheckedIOException(file, e);
      }
      setName("picture." + key);
      setToolTipText(name);
      fit(USUAL_WIDTH);
      addComponentListener(
          new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
              fit(getWidth());
            }
          });
    }

    /** Asks for the height that belongs to a width. */
    private void fit(int width) {
      if (height(width) != getPreferredSize().height) {
        setPreferredSize(new Dimension(USUAL_WIDTH, height(width)));
        setMinimumSize(new Dimension(LEAST_WIDTH, height(width)));
        revalidate();
      }
    }

    private int height(int width) {
      return width * image.getHeight() / image.getWidth();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      Graphics2D g = (Graphics2D) graphics.create();
      g.setRenderingHint(
          RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
      int width = Math.min(getWidth(), getHeight() * image.getWidth() / image.getHeight());
      g.drawImage(image, 0, 0, width, height(width), null);
      g.dispose();
    }
  }
}
