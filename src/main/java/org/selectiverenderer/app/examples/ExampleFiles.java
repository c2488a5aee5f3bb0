package org.selectiverenderer.app.examples;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.selectiverenderer.base.files.ProgramLocation;

/** Reads the examples of this program: the files below {@code examples/} in its jar. */
public final class ExampleFiles {
  private static final String ROOT = "examples/";

  /** Most bytes of one file: a jar that was tampered with is not unpacked without end. */
  private static final int MOST = 64 << 20;

  private ExampleFiles() {}

  /**
   * Reads all examples.
   *
   * @return their contents by their names, which have slashes, such as {@code scenes/trashcan.x3d}
   * @throws IOException with one sentence if this build has none, or they cannot be read
   */
  public static Map<String, byte[]> read() throws IOException {
    Path place =
        ProgramLocation.of(ExampleFiles.class)
            .orElseThrow(() -> new IOException("the program's own files are not to be found"));
    Map<String, byte[]> examples = Files.isDirectory(place) ? folder(place) : jar(place);
    if (examples.isEmpty()) {
      throw new IOException(
          place + " holds no examples; build it with Maven, or take them from the release");
    }
    return examples;
  }

  private static Map<String, byte[]> jar(Path place) throws IOException {
    Map<String, byte[]> examples = new TreeMap<>();
    try (ZipFile jar = new ZipFile(place.toFile())) {
      for (ZipEntry entry : (Iterable<ZipEntry>) jar.stream().map(ZipEntry.class::cast)::iterator) {
        if (entry.getName().startsWith(ROOT) && !entry.isDirectory()) {
          try (InputStream content = jar.getInputStream(entry)) {
            byte[] bytes = content.readNBytes(MOST + 1);
            if (bytes.length > MOST) {
              throw new IOException(
                  "%s of %s is longer than an example may be".formatted(entry.getName(), place));
            }
            examples.put(entry.getName().substring(ROOT.length()), bytes);
          }
        }
      }
    }
    return examples;
  }

  private static Map<String, byte[]> folder(Path place) throws IOException {
    Map<String, byte[]> examples = new TreeMap<>();
    Path root = place.resolve(ROOT);
    if (!Files.isDirectory(root)) {
      return examples;
    }
    try (Stream<Path> found = Files.walk(root)) {
      for (Path file : found.filter(Files::isRegularFile).toList()) {
        examples.put(root.relativize(file).toString().replace('\\', '/'), Files.readAllBytes(file));
      }
    }
    return examples;
  }
}
