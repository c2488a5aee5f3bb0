package org.selectiverenderer.cli.base;

import java.util.Map;

/**
 * System properties that libraries read once, when their classes load; so they are set before
 * anything else happens. What the user has set on the command line of Java is kept.
 */
public final class LibraryProperties {
  private static final Map<String, String> VALUES =
      Map.of(
          // JOML without sun.misc.Unsafe, of which newer Java versions warn.
          "joml.nounsafe", "true",
          // Windows are JOGL's own: without this JOGL starts AWT's toolkit beside them.
          "java.awt.headless", "true",
          // JOGL would try OpenGL ES too, and say at length where there is none.
          "jogl.disable.opengles", "true",
          // How long a thread of JOGL waits for another, in milliseconds, before it gives up: a
          // driver
          // may take longer than JOGL's 5 s to begin on a busy machine.
          "jogamp.common.utils.locks.Lock.timeout", "120000",
          // A console only where somebody sits at it; Java 22 to 24 make one of any input.
          "jdk.console", "java.base",
          // No probing for Groovy closures in every command.
          "picocli.disable.closures", "true",
          // No converters of options that nobody has: they take classes of java.sql and java.time.
          "picocli.converters.excludes", "java\\.(sql|time)\\..*");

  /** From this Java on, LWJGL can do without sun.misc.Unsafe, but does so only when told. */
  private static final int FOREIGN_MEMORY = 25;

  private LibraryProperties() {}

  public static void set() {
    VALUES.forEach(LibraryProperties::set);
    if (Runtime.version().feature() >= FOREIGN_MEMORY) {
      set("org.lwjgl.system.memoryBackend", "ffm");
    }
  }

  /**
   * Lets Swing open windows too. To be called when JOGL has begun, which then leaves AWT's toolkit
   * alone, and before AWT has, which asks once.
   */
  public static void allowSwing() {
    System.setProperty("java.awt.headless", "false");
  }

  /**
   * Lets Java find out whether there is a display for Swing, for a command that is a Swing window
   * itself. To be called before AWT and JOGL begin.
   */
  public static void swingFirst() {
    System.clearProperty("java.awt.headless");
  }

  private static void set(String name, String value) {
    if (System.getProperty(name) == null) {
      System.setProperty(name, value);
    }
  }
}
