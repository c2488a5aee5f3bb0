package org.selectiverenderer.render.context;

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
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.ProgramLocation;

/**
 * Unpacks JOGL's native libraries once into a folder beside the jar that contains them. JOGL itself
 * unpacks them at every start, and runs a script to find an executable folder; that takes a fifth
 * of a second of processor time. Here they are unpacked when the jar is new, and loaded from the
 * folder from then on.
 */
public final class JoglNativeLibraries {
  private static final String FOLDER = "natives";

  /** The file that is written last; it identifies the jar that the folder was made from. */
  private static final String COMPLETE = "complete";

  /**
   * Stands in place of the jar's modification time where a package contains both jar and folder,
   * because installers and archives change the times of files.
   */
  private static final String PACKAGED = "packaged";

  private JoglNativeLibraries() {}

  /**
   * Makes JOGL load its libraries from the folder. To be called before the first use of JOGL, whose
   * initial settings stay; a second call does nothing. Where there is no folder and none can be
   * written, or the program does not run from a jar, JOGL unpacks them as usual.
   */
  public static synchronized void use() {
    ProgramLocation.of(JoglNativeLibraries.class)
        .filter(Files::isRegularFile)
        .ifPresent(JoglNativeLibraries::use);
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

  /** Returns JOGL's name of the platform, where its folder in the jar is known. */
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
   * Returns the folder with all native libraries for a platform, made anew when it is missing or
   * from another jar.
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
        AtomicFileWriter.replace(complete, made.getBytes(StandardCharsets.UTF_8));
      }
      return Optional.of(folder);
    } catch (IOException e) {
      return Optional.empty(); // JOGL unpacks itself, or reports why not.
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
          continue; // Not a library.
        }
        try (InputStream in = file.getInputStream(library)) {
          AtomicFileWriter.replace(folder.resolve(name), in.readAllBytes());
        }
      }
      return !libraries.isEmpty();
    }
  }
}
