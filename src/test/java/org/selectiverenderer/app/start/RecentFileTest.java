package org.selectiverenderer.app.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.RecentFiles;

class RecentFileTest {
  @TempDir Path folder;

  @Test
  void filesOfAllWindowsAreListedWithTheCommandThatOpensThemUnlessTheyAreGone() throws IOException {
    Path settings = folder.resolve("settings");
    Path scene = Files.writeString(folder.resolve("a.x3d"), "");
    Path enriched = Files.writeString(folder.resolve("b.x3d"), "");
    Path study = Files.writeString(folder.resolve("study.json"), "");
    assertThat(RecentFile.list(settings)).isEmpty();
    RecentPaths.scenes(settings).add(scene);
    RecentPaths.scenes(settings).add(folder.resolve("gone.x3d"));
    RecentPaths.studies(settings).add(study);
    EnricherSettings enricher = new EnricherSettings(settings);
    new RecentFiles(enricher).add(enriched);
    enricher.store();
    assertThat(RecentFile.list(settings))
        .extracting(file -> file.command().words())
        .containsExactly(
            List.of("run", scene.toString()),
            List.of("enrich", enriched.toString()),
            List.of("experiment", "--study", study.toString()));
  }
}
