package org.selectiverenderer.doctor.probe;

import java.awt.AWTError;
import java.awt.Font;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.render.context.GlAvailability;

/**
 * Checks what the enricher and the questionnaires need: AWT windows and fonts with Greek letters.
 */
final class AwtProbe {
  private static final String SUBJECT = "Java's windows";
  private static final String GREEK = "Σχήμα μνήμης ΐΰάέήίόύώ";

  private AwtProbe() {}

  static void run(Consumer<Diagnosis> found) {
    Optional<String> reason = GlAvailability.check();
    if (reason.isPresent()) {
      found.accept(Diagnosis.lacking(SUBJECT, "there is no display", "see the line display"));
      return;
    }
    System.clearProperty("java.awt.headless"); // As the enricher does, before AWT starts.
    try {
      Toolkit.getDefaultToolkit();
      List<String> screens = new ArrayList<>();
      for (GraphicsDevice device :
          GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices()) {
        screens.add(text(device.getDefaultConfiguration()));
      }
      found.accept(Diagnosis.ok(SUBJECT, String.join("; ", screens)));
    } catch (HeadlessException | AWTError | LinkageError e) {
      found.accept(
          Diagnosis.lacking(
              SUBJECT,
              "this Java cannot open windows (" + e.getMessage() + ")",
              "install a Java that is not headless: openjdk-17-jdk instead of"
                  + " openjdk-17-jdk-headless"));
    }
  }

  private static String text(GraphicsConfiguration screen) {
    return "%dx%d, scale %s"
        .formatted(
            screen.getBounds().width,
            screen.getBounds().height,
            String.format(Locale.ROOT, "%.3g", screen.getDefaultTransform().getScaleX()));
  }

  static void fonts(Consumer<Diagnosis> found) {
    try {
      Font font = new Font(Font.DIALOG, Font.PLAIN, 12);
      found.accept(
          font.canDisplayUpTo(GREEK) < 0
              ? Diagnosis.ok(
                  "fonts",
                  font.getFamily(Locale.ROOT) + " has Greek letters; scenes bring their own")
              : Diagnosis.warning(
                  "fonts",
                  font.getFamily(Locale.ROOT) + " has no Greek letters",
                  "install a font that has, such as DejaVu (Debian: fonts-dejavu-core)"));
    } catch (RuntimeException | LinkageError e) { // Thrown where fontconfig has no font.
      found.accept(
          Diagnosis.lacking(
              "fonts",
              "Java finds none (" + e + ")",
              "install fontconfig and a font, such as DejaVu (Debian: fonts-dejavu-core)"));
    }
  }
}
