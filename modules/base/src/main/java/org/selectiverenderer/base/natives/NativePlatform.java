package org.selectiverenderer.base.natives;

import java.util.Locale;
import java.util.Optional;

/** The operating system and processor for which native libraries are taken. */
public enum NativePlatform {
  /** Linux on x86-64. */
  LINUX_X64,
  /** Linux on 64-bit ARM. */
  LINUX_ARM64,
  /** Windows on x86-64. */
  WINDOWS_X64,
  /** Windows on 64-bit ARM, for which JOGL has no libraries. */
  WINDOWS_ARM64,
  /** The macOS of Intel's processors. */
  MACOS_X64,
  /** The macOS of Apple's processors. */
  MACOS_ARM64;

  /** Returns the platform of this machine; empty if the program brings nothing for it. */
  public static Optional<NativePlatform> current() {
    return of(System.getProperty("os.name", ""), System.getProperty("os.arch", ""));
  }

  /** Returns the platform of Java's properties {@code os.name} and {@code os.arch}. */
  static Optional<NativePlatform> of(String system, String processor) {
    String name = system.toLowerCase(Locale.ROOT);
    boolean arm = processor.equals("aarch64") || processor.equals("arm64");
    if (!arm && !processor.equals("amd64") && !processor.equals("x86_64")) {
      return Optional.empty();
    }
    if (name.contains("mac")) {
      return Optional.of(arm ? MACOS_ARM64 : MACOS_X64);
    }
    if (name.contains("windows")) {
      return Optional.of(arm ? WINDOWS_ARM64 : WINDOWS_X64);
    }
    return name.contains("linux") ? Optional.of(arm ? LINUX_ARM64 : LINUX_X64) : Optional.empty();
  }

  /** Returns whether the system is Windows. */
  public boolean windows() {
    return this == WINDOWS_X64 || this == WINDOWS_ARM64;
  }

  /** Returns whether the system is macOS. */
  public boolean mac() {
    return this == MACOS_X64 || this == MACOS_ARM64;
  }

  /** Returns whether the processor is a 64-bit ARM; else it is an x86-64. */
  public boolean arm() {
    return this == LINUX_ARM64 || this == WINDOWS_ARM64 || this == MACOS_ARM64;
  }

  /** Returns the name of a library's file, such as {@code libassimp.so} for {@code assimp}. */
  public String file(String library) {
    if (windows()) {
      return library + ".dll";
    }
    return "lib" + library + (mac() ? ".dylib" : ".so");
  }
}
