package org.selectiverenderer.app.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.enricher.WindowIcon;

/**
 * The pictures that are shown before a window is there. {@code -Dreports.update=true} draws them
 * anew.
 */
class SplashPictureTest {
  private static final Path FOLDER = Path.of("src/main/resources/org/selectiverenderer/app/start");
  private static final int WIDTH = 420;
  private static final int HEIGHT = 180;
  private static final long MOST_BYTES = 20_000;

  private static Path file(int scale) {
    // Java looks for this name on a screen of twice the pixels.
    return FOLDER.resolve(scale == 1 ? "splash.png" : "splash@2x.png");
  }

  private static BufferedImage draw(int scale) {
    BufferedImage image =
        new BufferedImage(WIDTH * scale, HEIGHT * scale, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setColor(new Color(0x1f4e79));
    g.fillRect(0, 0, image.getWidth(), image.getHeight());
    int icon = 88 * scale;
    g.drawImage(WindowIcon.image(icon), 30 * scale, 46 * scale, null);
    g.setColor(new Color(0xeaf2fa));
    g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 26 * scale));
    g.drawString("Selective", 142 * scale, 84 * scale);
    g.drawString("Renderer", 142 * scale, 116 * scale);
    g.setColor(new Color(0xf2a33a));
    g.fillRect(0, image.getHeight() - 4 * scale, image.getWidth(), 4 * scale);
    g.dispose();
    return image;
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void thePictureIsSmallAndThereForBothKindsOfScreens(int scale) throws IOException {
    if (Boolean.getBoolean("reports.update")) {
      ImageIO.write(draw(scale), "png", file(scale).toFile());
    }
    BufferedImage kept = ImageIO.read(file(scale).toFile());
    assertThat(kept.getWidth()).isEqualTo(WIDTH * scale);
    assertThat(kept.getHeight()).isEqualTo(HEIGHT * scale);
    assertThat(Files.size(file(scale))).isLessThan(MOST_BYTES);
  }

  @Test
  void thePackagesTakeItAlong() throws IOException {
    assertThat(Files.readString(Path.of("packaging/package"))).contains("app/start/splash*.png");
  }
}
