package org.selectiverenderer.command;

import java.util.Map;

/**
 * Sets system properties of libraries, which read them once when their classes load, so this must
 * be done first. Properties that the user has set on Java's command line are kept.
 */
public final class LibraryProperties {
  private static final Map<String, String> VALUES =
      Map.of(
          // JOML without sun.misc.Unsafe, of which newer Java versions warn.
          "joml.nounsafe", "true",
          // Windows are JOGL's own: without this, JOGL also starts the AWT toolkit.
          "java.awt.headless", "true",
          // JOGL would try OpenGL ES too, and print long messages where there is none.
          "jogl.disable.opengles", "true",
          // How long a thread of JOGL waits for another, in milliseconds, before it gives up: a
          // driver
          // may take longer than JOGL's 5 s to begin on a busy machine.
          "jogamp.common.utils.locks.Lock.timeout", "120000",
          // System.console() only on a terminal; Java 22 to 24 return one for any input.
          "jdk.console", "java.base",
          // No probing for Groovy closures in every command.
          "picocli.disable.closures", "true",
          // No converters for unused option types: they load classes of java.sql and java.time.
          "picocli.converters.excludes", "java\\.(sql|time)\\..*");

  /**
   * The first Java version in which LWJGL can do without sun.misc.Unsafe; it does so only when the
   * property is set.
   */
  private static final int FOREIGN_MEMORY = 25;

  private LibraryProperties() {}

  public static void set() {
    VALUES.forEach(LibraryProperties::set);
    if (Runtime.version().feature() >= FOREIGN_MEMORY) {
      set("org.lwjgl.system.memoryBackend", "ffm");
    }
  }

  /**
   * Lets Swing open windows too. To be called after JOGL has started, which then leaves the AWT
   * toolkit alone, and before AWT has started, which reads the property once.
   */
  public static void allowSwing() {
    System.setProperty("java.awt.headless", "false");
  }

  /**
   * Lets AWT detect a display, for a command whose window is a Swing window. To be called before
   * AWT and JOGL start.
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
