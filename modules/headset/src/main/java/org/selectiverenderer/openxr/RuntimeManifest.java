package org.selectiverenderer.openxr;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Finds the manifest file of the active OpenXR runtime (Khronos, OpenXR Loader Design and
 * Operation, "Desktop Active Runtime File Location" and "Overriding the Default Runtime Usage").
 */
public final class RuntimeManifest {
  private static final String VARIABLE = "XR_RUNTIME_JSON";
  private static final String FOLDER = "openxr/1";

  private RuntimeManifest() {}

  /**
   * Returns the file that the loader uses on Linux: the one that {@value #VARIABLE} names, whether
   * it exists or not, else the first existing one.
   *
   * @param environment environment variables of the process
   * @param home the user's home folder
   * @param root root of the file system
   * @return empty if no runtime is set up
   */
  public static Optional<Path> find(Map<String, String> environment, Path home, Path root) {
    String named = environment.getOrDefault(VARIABLE, "");
    if (!named.isEmpty()) {
      return Optional.of(Path.of(named));
    }
    return folders(environment, home, root).stream()
        .map(folder -> folder.resolve(FOLDER))
        .flatMap(
            folder ->
                List.of(
                    folder.resolve("active_runtime." + architecture() + ".json"),
                    folder.resolve("active_runtime.json"))
                    .stream())
        .filter(Files::exists)
        .findFirst();
  }

  private static List<Path> folders(Map<String, String> environment, Path home, Path root) {
    List<Path> folders = new ArrayList<>();
    String own = environment.getOrDefault("XDG_CONFIG_HOME", "");
    folders.add(own.isEmpty() ? home.resolve(".config") : Path.of(own));
    String shared = environment.getOrDefault("XDG_CONFIG_DIRS", "");
    for (String folder : shared.split(":")) {
      folders.add(folder.isEmpty() ? root.resolve("etc/xdg") : Path.of(folder));
    }
    folders.add(root.resolve("usr/local/etc"));
    folders.add(root.resolve("etc"));
    return folders;
  }

  private static String architecture() {
    String name = System.getProperty("os.arch", "");
    return name.equals("amd64") ? "x86_64" : name;
  }
}
