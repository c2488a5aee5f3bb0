package org.selectiverenderer.cli;

import java.util.Map;

/**
 * System properties that libraries read once, when their classes load; so they are set before
 * anything else happens. What the user has set on the command line of Java is kept.
 */
final class LibraryProperties {
  private static final Map<String, String> VALUES =
      Map.of(
          // JOML without sun.misc.Unsafe, of which newer Java versions warn.
          "joml.nounsafe", "true",
          // Windows are JOGL's own: without this JOGL starts AWT's toolkit beside them.
          "java.awt.headless", "true",
          // JOGL would try OpenGL ES too, and say at length where there is none.
          "jogl.disable.opengles", "true",
          // No probing for Groovy closures in every command.
          "picocli.disable.closures", "true");

  private LibraryProperties() {}

  static void set() {
    VALUES.forEach(
        (name, value) -> {
          if (System.getProperty(name) == null) {
            System.setProperty(name, value);
          }
        });
  }
}
