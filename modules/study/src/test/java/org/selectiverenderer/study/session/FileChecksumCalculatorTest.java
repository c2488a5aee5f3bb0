package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresSymbolicLinks;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;

class FileChecksumCalculatorTest {
  @TempDir Path dir;

  @Test
  @RequiresSymbolicLinks
  void aFileThatTheSceneMayNotReadHasNoChecksum() throws IOException {
    Path folder = Files.createDirectory(dir.resolve("study"));
    Path scene =
        Files.writeString(
            folder.resolve("a.x3d"),
            "<Inline url='\"b.x3d\"'/><ImageTexture url='\"../secret.png\"'/>"
                + "<ImageTexture url='\"own.png\"'/>");
    Files.writeString(folder.resolve("b.x3d"), "<ImageTexture url='\"link.png\"'/>");
    Files.writeString(folder.resolve("own.png"), "own");
    Path secret = Files.writeString(dir.resolve("secret.png"), "secret");
    Files.createSymbolicLink(folder.resolve("link.png"), secret);

    assertThat(FileChecksumCalculator.ofScene(scene, ContentAccessPolicy.none()))
        .containsOnlyKeys("a.x3d", "b.x3d", "own.png");
    ContentAccessPolicy agreed = new ContentAccessPolicy(List.of(dir), HttpFetcher.none());
    assertThat(FileChecksumCalculator.ofScene(scene, agreed))
        .containsOnlyKeys("a.x3d", "b.x3d", "own.png", "link.png", "../secret.png");
  }
}
