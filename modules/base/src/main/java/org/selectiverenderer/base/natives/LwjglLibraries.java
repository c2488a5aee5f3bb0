package org.selectiverenderer.base.natives;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Makes LWJGL load its native parts from a folder of the user's own: those with a setting for their
 * file by its absolute path, which LWJGL loads without any search, and the others by the folder
 * into which LWJGL unpacks, where it finds them.
 */
public final class LwjglLibraries {
  /** A module of LWJGL whose native part the program loads. */
  public enum Part {
    /** LWJGL itself, with libffi in it. */
    CORE("", List.of("lwjgl")),
    /** Assimp, and Draco, which it loads. */
    ASSIMP("assimp/", List.of("draco", "assimp")),
    /** The meshoptimizer, with LWJGL's calls in the same file. */
    MESHOPTIMIZER("meshoptimizer/", List.of("lwjgl_meshoptimizer")),
    /** The loader of OpenXR, which macOS lacks. */
    OPENXR("openxr/", List.of("openxr"));

    private final String folder;
    private final List<String> libraries;

    Part(String folder, List<String> libraries) {
      this.folder = folder;
      this.libraries = libraries;
    }

    private List<String> resources(NativePlatform platform) {
      return libraries.stream()
          .map(library -> place(platform) + folder + file(platform, library))
          .toList();
    }
  }

  private static final String EXTRACTED = "org.lwjgl.system.SharedLibraryExtractPath";

  private LwjglLibraries() {}

  /**
   * Unpacks parts, and the core, which all need. To be called before the first use of a part's
   * classes; again it only compares. What the user has set on Java's command line is kept.
   *
   * @param owner a class whose loader finds LWJGL's native parts
   * @throws java.io.UncheckedIOException with one line, if there is no safe folder
   */
  public static synchronized void use(Class<?> owner, Part... parts) {
    use(NativeLibraryFolder.ofUser(), owner, NativePlatform.current(), parts);
  }

  static void use(
      NativeLibraryFolder folder,
      Class<?> owner,
      Optional<NativePlatform> platform,
      Part... parts) {
    // LWJGL adds the folder into which it unpacks to the path of its libraries.
    boolean named =
        System.getProperty("org.lwjgl.librarypath") != null
            && System.getProperty(EXTRACTED) == null;
    if (platform.isEmpty() || named) {
      return; // The system's own libraries are taken, or those that the user has named.
    }
    List<String> resources = new ArrayList<>(Part.CORE.resources(platform.get()));
    for (Part part : parts) {
      boolean none = part == Part.OPENXR && platform.get().mac();
      resources.addAll(none || part == Part.CORE ? List.of() : part.resources(platform.get()));
    }
    Path made = folder.unpack(owner, "lwjgl", resources);
    // All at once: LWJGL reads them when its first class loads.
    set("org.lwjgl.libname", made.resolve(file(platform.get(), "lwjgl")));
    set("org.lwjgl.assimp.draco.libname", made.resolve(file(platform.get(), "draco")));
    set("org.lwjgl.assimp.libname", made.resolve(file(platform.get(), "assimp")));
    if (!platform.get().mac()) {
      set("org.lwjgl.openxr.libname", made.resolve(file(platform.get(), "openxr")));
    }
    set(EXTRACTED, made);
  }

  private static String place(NativePlatform platform) {
    String system = platform.windows() ? "windows" : platform.mac() ? "macos" : "linux";
    return system + (platform.arm() ? "/arm64/" : "/x64/") + "org/lwjgl/";
  }

  private static String file(NativePlatform platform, String library) {
    if (library.equals("openxr")) {
      return platform.windows() ? "openxr-loader.dll" : "libopenxr_loader.so";
    }
    return platform.file(library);
  }

  private static void set(String name, Path value) {
    if (System.getProperty(name) == null) {
      System.setProperty(name, value.toString());
    }
  }
}
