package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The logo of the site is the program's icon. */
class SiteLogoTest {
  private static final Path LOGO = Path.of("packaging/site/assets/logo.png");
  private static final int SIZE = 128;

  /** {@code mvn test -Dtest=SiteLogoTest -Dreports.update=true} writes the logo anew. */
  @Test
  void theLogoIsTheIcon() throws IOException {
    BufferedImage icon = WindowIcon.image(SIZE);
    if (Boolean.getBoolean("reports.update")) {
      ImageIO.write(icon, "png", LOGO.toFile());
    }
    BufferedImage logo = ImageIO.read(LOGO.toFile());
    assertThat(logo.getWidth()).isEqualTo(SIZE);
    assertThat(logo.getHeight()).isEqualTo(SIZE);
    double difference = 0;
    for (int y = 0; y < SIZE; y++) {
      for (int x = 0; x < SIZE; x++) {
        difference +=
            difference(new Color(logo.getRGB(x, y), true), new Color(icon.getRGB(x, y), true));
      }
    }
    // Edges may be smoothed a little differently by another Java.
    assertThat(difference / SIZE / SIZE).isLessThan(1);
  }

  /** Of two colours, in levels of 255 on average over red, green, blue and alpha. */
  private static double difference(Color a, Color b) {
    return (Math.abs(a.getRed() - b.getRed())
            + Math.abs(a.getGreen() - b.getGreen())
            + Math.abs(a.getBlue() - b.getBlue())
            + Math.abs(a.getAlpha() - b.getAlpha()))
        / 4.0;
  }
}
