package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.testing.RequiresDisplay;

/** What a scene inlines or shows is lost to no command that writes a file. */
class SceneFileOverwriteTest extends CommandTestCase {
  @TempDir private Path folder;
  private Path scene;
  private Path texture;
  private Path inlined;

  @BeforeEach
  void makeScene() throws IOException {
    texture = Files.write(folder.resolve("wood.png"), PngEncoder.of(1, 1, new byte[3]));
    inlined =
        Files.writeString(
            folder.resolve("part.x3d"),
            """
            <X3D version='4.0' profile='Immersive'><Scene><Shape><Appearance><Material/>
            <ImageTexture url='"wood.png"'/></Appearance><Sphere/></Shape></Scene></X3D>
            """);
    scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            """
            <X3D version='4.0' profile='Immersive'><Scene><Inline url='"part.x3d"'/></Scene></X3D>
            """);
  }

  private void refuses(Path kept, String... command) throws IOException {
    byte[] before = Files.readAllBytes(kept);
    assertThat(execute(command)).as(String.join(" ", command)).isEqualTo(2);
    assertThat(messages().lines())
        .last()
        .asString()
        .contains(kept.getFileName() + ": is a file of the scene and would be overwritten");
    assertThat(kept).hasBinaryContent(before);
  }

  @Test
  void polygonsDrawsNoChartOverATexture() throws IOException {
    refuses(texture, "polygons", scene.toString(), "--chart", folder + "/./wood.png");
    assertThat(printed()).isEmpty();
  }

  @Test
  void simplifyWritesNoModelOverOneThatItInlines() throws IOException {
    refuses(
        inlined,
        "simplify",
        scene.toString(),
        "--vert-percent",
        "50",
        "--output",
        inlined.toString());
  }

  @Test
  void convertWritesNoSceneOverOneThatItInlines() throws IOException {
    refuses(inlined, "convert", scene.toString(), inlined.toString());
  }

  @Test
  void validateWritesNoReportOverATexture() throws IOException {
    refuses(texture, "validate", scene.toString(), "--output", texture.toString());
  }

  @Test
  @RequiresDisplay
  void runWritesNothingOverWhatItShows() throws IOException {
    for (String option : List.of("--screenshot", "--timeline", "--stats")) {
      refuses(
          texture, "run", scene.toString(), "--offscreen", "--mute", option, texture.toString());
    }
    refuses(
        inlined,
        "run",
        scene.toString(),
        "--offscreen",
        "--mute",
        "--timeline",
        inlined.toString());
  }

  @Test
  void saiWritesNoTimeLineOverTheScene() throws IOException {
    String before = Files.readString(scene);
    assertThat(execute("sai", scene.toString(), "--timeline", scene.toString())).isEqualTo(2);
    assertThat(messages()).contains("would overwrite the scene");
    assertThat(scene).hasContent(before);
  }
}
