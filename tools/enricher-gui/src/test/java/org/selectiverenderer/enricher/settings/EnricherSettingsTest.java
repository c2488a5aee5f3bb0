package org.selectiverenderer.enricher.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.x3d.url.HostPattern;

class EnricherSettingsTest {
  @TempDir Path folder;

  @Test
  void whatIsStoredIsThereAgainAtTheNextStart() throws IOException {
    EnricherSettings first = new EnricherSettings(folder.resolve("new"));
    first.put("split.tree", 240);
    new RecentFiles(first).add(folder.resolve("a.x3d"));
    new RecentFiles(first).add(folder.resolve("b.x3d"));
    new RecentFiles(first).add(folder.resolve("a.x3d"));
    first.store();
    EnricherSettings second = new EnricherSettings(folder.resolve("new"));
    second.load();
    assertThat(second.number("split.tree", 0)).isEqualTo(240);
    assertThat(new RecentFiles(second).list())
        .containsExactly(folder.resolve("a.x3d"), folder.resolve("b.x3d"));
  }

  @Test
  void damagedSettingsAreSaidAndTheUsualOnesUsed() throws IOException {
    Files.writeString(folder.resolve("enricher.properties"), "theme=\\u12");
    EnricherSettings settings = new EnricherSettings(folder);
    assertThatThrownBy(settings::load)
        .isInstanceOf(IOException.class)
        .hasMessageContaining("defaults are used");
    assertThat(settings.number("split.tree", 7)).isEqualTo(7);
  }

  @Test
  void foldersAndHostsThatScenesMayNameAreSettings() {
    EnricherSettings settings = new EnricherSettings(folder);
    assertThat(settings.access().folders()).isEmpty();
    settings.put("allow", "models" + File.pathSeparator + " other");
    settings.put("allow-net", "example.org, *.example.com");
    assertThat(settings.access().folders()).containsExactly(Path.of("models"), Path.of("other"));
    assertThat(settings.access().network().hosts())
        .extracting(HostPattern::text)
        .containsExactly("example.org", "*.example.com");
    settings.put("allow-net", "https://example.org");
    assertThatThrownBy(settings::access).hasMessageContaining("is no host");
  }
}
