package org.selectiverenderer.render.conformance;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.testing.RequiresDisplay;

/** A conformance scene whose expectations are not met fails. */
class ConformanceSceneTest {
  @TempDir Path folder;

  private ConformanceScene scene(String... meta) throws IOException {
    StringBuilder head = new StringBuilder();
    for (String one : meta) {
      String[] parts = one.split("=", 2);
      head.append("<meta name='%s' content='%s'/>".formatted(parts[0], parts[1]));
    }
    Path file = folder.resolve("scene.x3d");
    Files.writeString(
        file,
        "<X3D version='4.0' profile='Immersive'><head>%s</head><Scene><Switch DEF='S'/></Scene></X3D>"
            .formatted(head));
    return ConformanceScene.read(file);
  }

  @Test
  void whatIsSoPasses() throws IOException {
    ConformanceScene scene =
        scene("clause=any", "at=1 set S.whichChoice 1", "event=1 S.whichChoice 1", "at=2");
    assertThatCode(() -> ConformanceTest.run(scene)).doesNotThrowAnyException();
  }

  @ParameterizedTest
  @CsvSource({
    "event=1 S.whichChoice 2",
    "event=2 S.whichChoice 1",
    "event=1 S.visible true",
    "silent=S.whichChoice",
    "value=S.whichChoice 0",
    "says=something"
  })
  void whatIsNotSoFails(String meta) throws IOException {
    ConformanceScene scene = scene("clause=any", "at=1 set S.whichChoice 1", meta);
    assertThatThrownBy(() -> ConformanceTest.run(scene)).isInstanceOf(AssertionError.class);
  }

  @Test
  @RequiresDisplay
  void aPixelOfAnotherColourFails() throws IOException {
    ConformanceScene scene = scene("clause=any", "pixel=0.5 0.5 0 255 0");
    assertThatThrownBy(() -> ConformanceTest.draw(scene)).isInstanceOf(AssertionError.class);
  }

  @Test
  void aSceneNamesItsClauseAndNothingThatIsUnknown() {
    assertThatThrownBy(() -> scene("at=1")).hasMessageContaining("no meta names the clause");
    assertThatThrownBy(() -> scene("clause=any", "pixle=0 0 0 0 0"))
        .hasMessageContaining("has no meta pixle");
  }
}
