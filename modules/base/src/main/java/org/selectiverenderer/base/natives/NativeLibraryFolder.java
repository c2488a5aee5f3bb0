package org.selectiverenderer.base.natives;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.CRC32;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.CacheFolder;
import org.selectiverenderer.base.files.HomeFolder;
import org.selectiverenderer.base.files.PrivateFolder;
import org.selectiverenderer.base.files.ProgramLocation;

/**
 * The folder from which native libraries are loaded: the one that a package brings beside the jar,
 * else one in the user's cache, see {@link PrivateFolder}. Each file in it has the bytes that the
 * class path has; another one is replaced before it is loaded.
 */
public final class NativeLibraryFolder {
  private static final String PROGRAM = "selective-renderer";
  private static final String NATIVES = "natives";

  private final Path cache;
  private final String variable;

  NativeLibraryFolder(Path cache, String variable) {
    this.cache = cache;
    this.variable = variable;
  }

  /** Returns the folder of this user. */
  public static NativeLibraryFolder ofUser() {
    String system = System.getProperty("os.name", "");
    return new NativeLibraryFolder(
        CacheFolder.of(system, HomeFolder.ofUser(), System.getenv()), CacheFolder.variable(system));
  }

  /**
   * Returns the folder that a package brings beside the jar, if it has all these libraries
   * unchanged and nobody else can change them; else that of {@link #unpack}.
   */
  public Path packaged(Class<?> owner, String library, List<String> resources) {
    Optional<Path> beside =
        ProgramLocation.of(owner)
            .filter(Files::isRegularFile)
            .map(jar -> jar.resolveSibling(resources.get(0)).getParent())
            .filter(folder -> whole(folder, contents(owner, library, resources)));
    return beside.orElseGet(() -> unpack(owner, library, resources));
  }

  private static boolean whole(Path folder, Map<String, byte[]> contents) {
    try {
      if (!Files.isDirectory(folder)) {
        return false;
      }
      Path real = folder.toRealPath();
      if (PrivateFolder.fault(real).isPresent()) {
        return false;
      }
      for (Map.Entry<String, byte[]> each : contents.entrySet()) {
        if (!same(real.resolve(each.getKey()), each.getValue())) {
          return false;
        }
      }
      return true;
    } catch (IOException e) {
      return false; // The user's cache is taken.
    }
  }

  /**
   * Returns a folder that has libraries with the bytes of resources, after it has written what is
   * missing or different.
   *
   * @param owner a class whose loader finds the resources
   * @param library what the folder is called, with a sum of the first resource: versions that run
   *     at the same time have a folder each
   * @throws UncheckedIOException with one line, if there is no such resource or no safe folder
   */
  public Path unpack(Class<?> owner, String library, List<String> resources) {
    Map<String, byte[]> contents = contents(owner, library, resources);
    CRC32 sum = new CRC32();
    sum.update(contents.values().iterator().next());
    try {
      Path folder =
          PrivateFolder.make(cache, PROGRAM, NATIVES, library + "-%08x".formatted(sum.getValue()));
      for (Map.Entry<String, byte[]> each : contents.entrySet()) {
        Path file = folder.resolve(each.getKey());
        if (!same(file, each.getValue())) {
          replace(file, each.getValue());
        }
      }
      return folder;
    } catch (IOException e) {
      throw failed(library, e.getMessage() + ", or name another folder by " + variable, e);
    }
  }

  private static Map<String, byte[]> contents(
      Class<?> owner, String library, List<String> resources) {
    Map<String, byte[]> contents = new LinkedHashMap<>();
    for (String resource : resources) {
      try (@Nullable InputStream in = owner.getClassLoader().getResourceAsStream(resource)) {
        if (in == null) {
          throw new IOException("the program was built without " + resource);
        }
        contents.put(resource.substring(resource.lastIndexOf('/') + 1), in.readAllBytes());
      } catch (IOException e) {
        throw failed(library, e.getMessage(), e);
      }
    }
    return contents;
  }

  private static UncheckedIOException failed(String library, String reason, IOException cause) {
    return new UncheckedIOException(
        new IOException(
            "the native library %s is not loaded: %s".formatted(library, reason), cause));
  }

  /** Returns whether a file of this user's, or the administrator's, has these bytes. */
  private static boolean same(Path file, byte[] content) throws IOException {
    return PrivateFolder.closed(file)
        && Files.size(file) == content.length
        && Arrays.equals(Files.readAllBytes(file), content);
  }

  /** Replaces a file, or a link of that name, in one step: others may be loading it. */
  private static void replace(Path file, byte[] content) throws IOException {
    Path part = Files.createTempFile(file.getParent(), ".", ".part");
    try {
      Files.write(part, content);
      Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(part);
    }
  }
}
