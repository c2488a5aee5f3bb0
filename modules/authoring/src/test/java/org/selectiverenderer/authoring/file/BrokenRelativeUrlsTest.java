package org.selectiverenderer.authoring.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;

class BrokenRelativeUrlsTest {
  @TempDir Path folder;
  private Path here;
  private Path there;

  @BeforeEach
  void folders() throws IOException {
    here = Files.createDirectories(folder.resolve("here/scenes"));
    there = Files.createDirectories(folder.resolve("there"));
    Files.createDirectories(folder.resolve("here/parts"));
    Files.writeString(folder.resolve("here/parts/big cup.x3d"), "<X3D/>");
    Files.writeString(here.resolve("wood.png"), "");
  }

  private List<String> left(String nodes, Path to) throws IOException {
    String scene = "<X3D><Scene>" + nodes + "</Scene></X3D>";
    return BrokenRelativeUrls.in(
        SceneDocument.of("s.x3d", scene.getBytes(StandardCharsets.UTF_8)), here, to);
  }

  @Test
  void filesThatTheOtherFolderDoesNotReachAreLeftBehind() throws IOException {
    String nodes =
        """
        <Inline url='"../parts/big%20cup.x3d"'/><Inline url='"../parts/big cup.x3d#Cup"'/>
        <Shape><Appearance><ImageTexture url='"wood.png"'/></Appearance></Shape>
        """;
    assertThat(left(nodes, there))
        .containsExactly("../parts/big%20cup.x3d", "../parts/big cup.x3d#Cup", "wood.png");
  }

  @Test
  void nothingIsLeftBehindInTheSameFolderOrInOneThatReachesTheFilesToo() throws IOException {
    String inline = "<Inline url='\"../parts/big%20cup.x3d\"'/>";
    assertThat(left(inline, here)).isEmpty();
    assertThat(left(inline, Files.createDirectories(folder.resolve("here/copies")))).isEmpty();
  }

  @Test
  void whatIsMissingAlreadyOrAbsoluteOrHasAnotherWayIsNotLeftBehind() throws IOException {
    Files.writeString(there.resolve("other.png"), "");
    String nodes =
        """
        <Inline url='"gone.x3d"'/><Inline url='"https://example.org/a.x3d"'/>
        <Inline url='"::odd"'/><Anchor url='"#Door"'/>
        <Shape><Appearance><ImageTexture url='"wood.png" "other.png"'/></Appearance></Shape>
        """;
    assertThat(left(nodes, there)).isEmpty();
  }

  @Test
  void aTextThatIsNotWellFormedLeavesNothingBehind() throws IOException {
    assertThat(left("<Inline url='\"wood.png\"'>", there)).isEmpty();
  }
}
