package org.selectiverenderer.openxr;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The order of the loader's search (OpenXR Loader, "Desktop Active Runtime File Location"). */
class RuntimeManifestTest {
  private static final String NAME = "openxr/1/active_runtime.json";

  @TempDir private Path root;

  @Test
  void theUsersOwnGoesBeforeTheSystems() throws IOException {
    Path home = root.resolve("home");
    assertThat(RuntimeManifest.find(Map.of(), home, root)).isEmpty();
    Path system = made(root.resolve("etc").resolve(NAME));
    assertThat(RuntimeManifest.find(Map.of(), home, root)).contains(system);
    Path shared = made(root.resolve("etc/xdg").resolve(NAME));
    assertThat(RuntimeManifest.find(Map.of(), home, root)).contains(shared);
    Path own = made(home.resolve(".config").resolve(NAME));
    assertThat(RuntimeManifest.find(Map.of(), home, root)).contains(own);
  }

  @Test
  void variablesNameOthers() throws IOException {
    Path own = made(root.resolve("own").resolve(NAME));
    Map<String, String> folder = Map.of("XDG_CONFIG_HOME", root.resolve("own").toString());
    assertThat(RuntimeManifest.find(folder, root, root)).contains(own);
    Map<String, String> file = Map.of("XR_RUNTIME_JSON", "/opt/runtime.json");
    assertThat(RuntimeManifest.find(file, root, root)).contains(Path.of("/opt/runtime.json"));
  }

  private static Path made(Path file) throws IOException {
    Files.createDirectories(file.getParent());
    return Files.writeString(file, "{}");
  }
}
