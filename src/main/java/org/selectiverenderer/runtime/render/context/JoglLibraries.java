package org.selectiverenderer.runtime.render.context;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import org.selectiverenderer.base.files.ProgramPlace;
import org.selectiverenderer.base.files.WholeFile;

/**
 * JOGL's native parts in a folder beside the jar that brings them. JOGL itself unpacks them at
 * every start, and runs a script to find out where it may; that takes a fifth of a second of
 * processor time. They are unpacked here when the jar is new, and loaded from the folder from then
 * on.
 */
public final class JoglLibraries {
  private static final String FOLDER = "natives";

  /** Written last; holds which jar the folder was made of. */
  private static final String COMPLETE = "complete";

  /**
   * In the place of the jar's time, where a package brings both: installers and archives give files
   * times of their own.
   */
  private static final String PACKAGED = "packaged";

  private JoglLibraries() {}

  /**
   * Has JOGL load from the folder. To be called by whoever may be the first to touch JOGL: what it
   * has begun with stays, and a second call does nothing. Where there is no folder and none can be
   * written, or the program does not run from a jar, JOGL unpacks them as ever.
   */
  public static synchronized void use() {
    ProgramPlace.of(JoglLibraries.class).filter(Files::isRegularFile).ifPresent(JoglLibraries::use);
  }

  private static void use(Path jar) {
    if (System.getProperty("jogamp.gluegen.UseTempJarCache") != null) {
      return; // The user has decided.
    }
    platform(System.getProperty("os.name", ""), System.getProperty("os.arch", ""))
        .flatMap(platform -> folder(jar, platform))
        .ifPresent(
            folder -> {
              String before = System.getProperty("java.library.path", "");
              System.setProperty(
                  "java.library.path", folder + System.getProperty("path.separator") + before);
              System.setProperty("jogamp.gluegen.UseTempJarCache", "false");
            });
  }

  /** JOGL's name of the machine, as far as its folder in the jar is certain. */
  static Optional<String> platform(String system, String processor) {
    String name = system.toLowerCase(Locale.ROOT);
    String kind = processor.replace("x86_64", "amd64").replace("arm64", "aarch64");
    if (name.contains("mac")) {
      return Optional.of("macosx-universal");
    }
    if (name.contains("windows")) {
      return kind.equals("amd64") ? Optional.of("windows-amd64") : Optional.empty();
    }
    return name.contains("linux") && List.of("amd64", "aarch64").contains(kind)
        ? Optional.of("linux-" + kind)
        : Optional.empty();
  }

  /**
   * The folder with all native parts for a platform, made when it is missing or of another jar.
   *
   * @return empty when it cannot be made, or the jar has none for the platform
   */
  static Optional<Path> folder(Path jar, String platform) {
    Path folder = jar.resolveSibling(FOLDER).resolve(platform);
    Path complete = folder.resolve(COMPLETE);
    try {
      String size = Files.size(jar) + " ";
      String made = size + Files.getLastModifiedTime(jar).toMillis();
      String there = Files.exists(complete) ? Files.readString(complete) : "";
      if (!there.equals(made) && !there.equals(size + PACKAGED)) {
        if (!Files.isWritable(jar.toAbsolutePath().getParent()) || !unpack(jar, folder)) {
          return Optional.empty();
        }
        WholeFile.replace(complete, made.getBytes(StandardCharsets.UTF_8));
      }
      return Optional.of(folder);
    } catch (IOException e) {
      return Optional.empty(); // JOGL finds another place, or says why it cannot.
    }
  }

  /** Unpacks a platform's libraries; returns whether there are any. */
  private static boolean unpack(Path jar, Path folder) throws IOException {
    String inside = FOLDER + "/" + folder.getFileName() + "/";
    try (JarFile file = new JarFile(jar.toFile())) {
      List<JarEntry> libraries =
          file.stream()
              .filter(entry -> !entry.isDirectory() && entry.getName().startsWith(inside))
              .toList();
      if (!libraries.isEmpty()) {
        Files.createDirectories(folder);
      }
      for (JarEntry library : libraries) {
        String name = library.getName().substring(inside.length());
        if (name.contains("/") || name.contains("\\")) {
          continue; // None of ours.
        }
        try (InputStream in = file.getInputStream(library)) {
          WholeFile.replace(folder.resolve(name), in.readAllBytes());
        }
      }
      return !libraries.isEmpty();
    }
  }
}
