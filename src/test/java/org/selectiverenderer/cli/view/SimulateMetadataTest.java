package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.cli.view.SimulateTestCase.BOX;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Metadata that cannot be followed is told; the rest of the scene is rendered selectively. */
class SimulateMetadataTest {
  private static final String SENSOR =
      "<ProximitySensor DEF='P' center='0 0 10' size='2 2 2'>"
          + "<MetadataSet containerField='metadata'>"
          + "<MetadataString containerField='value' name='enterTimeSchema' value='\"B\"'/>"
          + "</MetadataSet></ProximitySensor>\n";

  @TempDir private Path temp;
  private SimulateTestCase folder;

  @BeforeEach
  void writePath() {
    folder = new SimulateTestCase(temp);
  }

  private static String part(String schema) {
    return "<MetadataSet containerField='value'>"
        + "<MetadataString containerField='value' name='schemaBelonginess' value='"
        + schema
        + "'/></MetadataSet>\n";
  }

  private static String object(String name, String parts, String children) {
    return "<Switch DEF='"
        + name
        + "' whichChoice='0'><MetadataSet containerField='metadata'>\n"
        + parts
        + "</MetadataSet>"
        + children
        + "</Switch>\n";
  }

  private static final String GOOD =
      object("Good", part("\"A\"") + part("\"B\""), BOX + "<Group>" + BOX + BOX + "</Group>");

  private SimulateTestCase.Result simulate(String nodes) {
    return folder.scene("scene.x3d", nodes).simulate("scene.x3d");
  }

  @Test
  void aSwitchWithFewerChildrenThanMetadataSetsIgnoresTheRest() {
    SimulateTestCase.Result result =
        simulate(SENSOR + object("Short", part("\"A\"") + part("\"B\""), BOX) + GOOD);
    assertThat(result.messages())
        .containsExactly(
            "scene.x3d:5:1: Short: 2 MetadataSets for 1 child of the Switch; this one is ignored");
    assertThat(result.out())
        .contains("\"switch\":\"Good\",\"from\":0,\"to\":1,\"schema\":\"B\"")
        .doesNotContain("\"switch\":\"Short\"");
    assertThat(result.polygons()).isEqualTo(36);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void metadataThatNamesNoSchemaIsTold() {
    SimulateTestCase.Result result =
        simulate(SENSOR + object("Nameless", part("\"A\"") + part("\"\""), BOX + BOX) + GOOD);
    assertThat(result.messages())
        .containsExactly(
            "scene.x3d:5:1: Nameless: the metadata names no schema; nothing activates this choice");
    assertThat(result.out())
        .contains("\"switch\":\"Good\"")
        .doesNotContain("\"switch\":\"Nameless\"");
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void metadataWithoutTheVocabularyIsNobodysBusiness() {
    SimulateTestCase.Result result =
        simulate(
            "<Switch whichChoice='0'><MetadataString name='author' value='\"me\"'/>"
                + BOX
                + "</Switch>");
    assertThat(result.messages()).isEmpty();
    assertThat(result.status()).isZero();
  }
}
