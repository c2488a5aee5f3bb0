package org.selectiverenderer.app.recent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecentPathsTest {
  @TempDir Path folder;

  @Test
  void theLatestStudyIsTheFirstAndEachIsThereOnce() throws IOException {
    RecentPaths recent = RecentPaths.studies(folder.resolve("settings"));
    assertThat(recent.list()).isEmpty();
    Path one = folder.resolve("one/study.json");
    Path two = folder.resolve("two words/μελέτη.json");
    recent.add(one);
    recent.add(two);
    recent.add(folder.resolve("x/../one/study.json"));
    assertThat(recent.list()).containsExactly(one, two);
    recent.remove(one);
    assertThat(RecentPaths.studies(folder.resolve("settings")).list()).containsExactly(two);
  }

  @Test
  void tenAreKept() throws IOException {
    RecentPaths recent = RecentPaths.studies(folder);
    for (int i = 0; i < 14; i++) {
      recent.add(folder.resolve("study" + i));
    }
    assertThat(recent.list())
        .hasSize(RecentPaths.MOST)
        .first()
        .isEqualTo(folder.resolve("study13"));
  }

  @Test
  void aDamagedListIsAnEmptyOne() throws IOException {
    Files.write(folder.resolve("studies"), new byte[] {(byte) 0xff, 0, 10});
    assertThat(RecentPaths.studies(folder).list()).isEmpty();
  }
}
