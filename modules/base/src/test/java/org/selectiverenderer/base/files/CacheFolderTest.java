package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

class CacheFolderTest {
  private static final Path HOME = Path.of("home").toAbsolutePath();

  @Test
  void eachSystemHasItsOwn() {
    assertThat(CacheFolder.of("Linux", HOME, Map.of())).isEqualTo(HOME.resolve(".cache"));
    assertThat(CacheFolder.of("Mac OS X", HOME, Map.of()))
        .isEqualTo(HOME.resolve("Library").resolve("Caches"));
    assertThat(CacheFolder.of("Windows 11", HOME, Map.of()))
        .isEqualTo(HOME.resolve("AppData").resolve("Local"));
  }

  @Test
  void theUserMayNameAnotherByAWholePath() {
    Path other = HOME.resolve("other");
    assertThat(CacheFolder.of("Linux", HOME, Map.of("XDG_CACHE_HOME", other.toString())))
        .isEqualTo(other);
    assertThat(CacheFolder.of("Linux", HOME, Map.of("XDG_CACHE_HOME", "shared")))
        .as("relative to whatever folder is the current one")
        .isEqualTo(HOME.resolve(".cache"));
    assertThat(CacheFolder.of("Windows 11", HOME, Map.of("LOCALAPPDATA", other.toString())))
        .isEqualTo(other);
  }
}
