package org.selectiverenderer.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.testing.X3dDocument;

class ManySwitchesSceneGeneratorTest {

  @TempDir Path dir;

  @ParameterizedTest
  @CsvSource({"100, 10", "25, 7", "3, 3"})
  void theSensorsSchemasBelongToTheAffectedSwitchesAndNoOthers(int switches, int affected)
      throws IOException {
    X3dDocument scene =
        X3dDocument.read(ManySwitchesSceneGenerator.write(dir, switches, affected).scene());

    assertThat(scene.elements("Switch")).hasSize(switches);
    assertThat(scene.elements("ProximitySensor")).hasSize(1);
    for (String schema :
        new String[] {
          ManySwitchesSceneGenerator.ENTER_SCHEMA, ManySwitchesSceneGenerator.EXIT_SCHEMA
        }) {
      assertThat(scene.elements("MetadataString"))
          .filteredOn(e -> e.getAttribute("name").equals("schemaBelonginess"))
          .filteredOn(e -> e.getAttribute("value").equals("\"" + schema + "\""))
          .hasSize(affected);
    }
  }

  @Test
  void bytesAreTheSameEveryTime() throws IOException {
    BenchScene first = ManySwitchesSceneGenerator.write(dir.resolve("a"), 40, 4);
    BenchScene second = ManySwitchesSceneGenerator.write(dir.resolve("b"), 40, 4);

    assertThat(first.scene()).hasSameBinaryContentAs(second.scene()).hasSize(first.bytes());
  }

  @ParameterizedTest
  @CsvSource({"10, 0", "10, 11"})
  void refusesNumbersThatDoNotFit(int switches, int affected) {
    assertThatThrownBy(() -> ManySwitchesSceneGenerator.write(dir, switches, affected))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("affected");
  }
}
