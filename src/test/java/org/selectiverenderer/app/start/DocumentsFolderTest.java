package org.selectiverenderer.app.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DocumentsFolderTest {
  @TempDir Path home;

  private Path named(String line) throws IOException {
    Path settings = Files.createDirectories(home.resolve("settings"));
    Files.writeString(settings.resolve("user-dirs.dirs"), "# a comment\n" + line + "\n");
    return DocumentsFolder.of(home, Map.of("XDG_CONFIG_HOME", settings.toString()));
  }

  @Test
  void aDesktopNamesItInItsLanguage() throws IOException {
    assertThat(named("XDG_DOCUMENTS_DIR=\"$HOME/Έγγραφα\"")).isEqualTo(home.resolve("Έγγραφα"));
    assertThat(named("XDG_DOCUMENTS_DIR=\"" + home.resolve("d") + "\""))
        .isEqualTo(home.resolve("d"));
  }

  @Test
  void whatIsNoNameOfAFolderIsPassedOver() throws IOException {
    Path usual = home.resolve("Documents");
    assertThat(named("XDG_MUSIC_DIR=\"$HOME/Music\"")).isEqualTo(usual);
    assertThat(named("XDG_DOCUMENTS_DIR=\"relative\"")).isEqualTo(usual);
    assertThat(named("XDG_DOCUMENTS_DIR=\"$(rm x)\"")).isEqualTo(usual);
    assertThat(DocumentsFolder.of(home, Map.of())).isEqualTo(usual);
  }
}
