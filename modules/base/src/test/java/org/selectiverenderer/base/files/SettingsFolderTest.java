package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SettingsFolderTest {
  private static final Path ROOT = FileSystems.getDefault().getRootDirectories().iterator().next();
  private static final Path HOME = ROOT.resolve("home").resolve("zoe");

  @Test
  void eachSystemHasItsFolder() {
    assertThat(SettingsFolder.of("Linux", HOME, Map.of()))
        .isEqualTo(HOME.resolve(".config/selective-renderer"));
    assertThat(SettingsFolder.of("Mac OS X", HOME, Map.of("XDG_CONFIG_HOME", "/x")))
        .isEqualTo(HOME.resolve("Library/Application Support/selective-renderer"));
    Path roaming = ROOT.resolve("roaming");
    assertThat(SettingsFolder.of("Windows 11", HOME, Map.of("APPDATA", roaming.toString())))
        .isEqualTo(roaming.resolve("selective-renderer"));
  }

  @Test
  void aFolderInTheCurrentOneIsNeverTheUsers() {
    assertThat(SettingsFolder.of("Linux", HOME, Map.of("XDG_CONFIG_HOME", "here")))
        .isEqualTo(HOME.resolve(".config/selective-renderer"));
    assertThat(SettingsFolder.of("Windows 11", HOME, Map.of("APPDATA", "here")))
        .isEqualTo(HOME.resolve("AppData/Roaming/selective-renderer"));
  }

  /** Java names the home of an account that the system does not know "?". */
  @ParameterizedTest
  @ValueSource(strings = {"?", "", "home"})
  void aHomeThatIsNoneIsNotSoughtInTheCurrentFolder(String property) {
    assertThat(HomeFolder.of(property)).isAbsolute().hasParentRaw(ROOT);
  }

  @Test
  void aHomeIsTakenAsItIs() {
    assertThat(HomeFolder.of(HOME.toString())).isEqualTo(HOME);
  }
}
