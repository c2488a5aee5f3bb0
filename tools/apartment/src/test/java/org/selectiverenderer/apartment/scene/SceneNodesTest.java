package org.selectiverenderer.apartment.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.apartment.facts.ExpectancyRatings;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.PlannedObject;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.RoomPosition;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.write.X3dWriter;

class SceneNodesTest {

  @Test
  void anObjectThatRevolvesSaysWhere() {
    assertThat(node("candle", Room.LOUNGE, true))
        .isEqualTo(
            """
            <Transform DEF='Transform_Candle' translation='1 0.5 -2' rotation='0 1 0 1.5708'>
              <Switch DEF='Switch_Candle' whichChoice='1'>
                <MetadataSet containerField='metadata' DEF='MetadataSet_CandleDefinition' name='Candle'>
                  <MetadataSet containerField='value' DEF='MetadataSetCandle_Part1Definition' name='Candle_v1'>
                    <MetadataString containerField='value' DEF='consistencyTypeDefinitionCandle_Part1' name='consistencyType' value='"inconsistent"'/>
                    <MetadataString containerField='value' DEF='degreeOfConsistencyDefinitionCandle_Part1' name='degreeOfConsistency' value='"low"'/>
                    <MetadataString containerField='value' DEF='schemaBelonginessDefinitionCandle_Part1' name='schemaBelonginess' value='"SofaSchema"'/>
                  </MetadataSet>
                  <MetadataSet containerField='value' DEF='MetadataSetCandle_Part2Definition' name='Candle_v2'>
                    <MetadataString containerField='value' DEF='consistencyTypeDefinitionCandle_Part2' name='consistencyType' value='"consistent"'/>
                    <MetadataString containerField='value' DEF='degreeOfConsistencyDefinitionCandle_Part2' name='degreeOfConsistency' value='"high"'/>
                    <MetadataString containerField='value' DEF='schemaBelonginessDefinitionCandle_Part2' name='schemaBelonginess' value='"LoungeSchema"'/>
                  </MetadataSet>
                </MetadataSet>
                <Inline DEF='Inline_Candle_v1_Definition' url='"../inlineNodes/candle_v1.x3d"'/>
                <Inline DEF='Inline_Candle_v2_Definition' url='"../inlineNodes/candle_v2.x3d"'/>
              </Switch>
            </Transform>
            """);
  }

  @Test
  void anObjectThatDoesNotRevolveHasNoSchemaForItsFirstVersion() {
    assertThat(node("teapot", Room.KITCHEN, true))
        .containsOnlyOnce("name='schemaBelonginess'")
        .isNotEmpty();
  }

  @Test
  void plainObjectsHaveNoMetadataAndOthersOneVersion() {
    assertThat(node("candle", Room.LOUNGE, false)).doesNotContain("Metadata").contains("Switch");
    assertThat(node("shovel", Room.KITCHEN, true))
        .doesNotContain("Metadata", "Switch")
        .contains("Inline_Shovel_Definition", "inlineNodes/shovel.x3d");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 | 0 | 0 1 0 0",
        "90 | 0 | 0 1 0 1.5708",
        "-90 | 0 | 0 -1 0 1.5708",
        "0 | -90 | -1 0 0 1.5708",
        "180 | -90 | 0 0.7071 0.7071 3.1416"
      })
  void viewpointsTurnFirstAndThenTilt(double yaw, double pitch, String orientation) {
    assertThat(FieldValueText.orientation(yaw, pitch)).isEqualTo(orientation);
  }

  @Test
  void thePracticeSceneReadsWithoutProblems() {
    ProblemCollector problems = new ProblemCollector();
    byte[] bytes = PracticeScene.text().getBytes(StandardCharsets.UTF_8);
    var file = new X3dReader(NodeCatalogue.load()).read("practice.x3d", bytes, problems);

    assertThat(problems.list()).isEmpty();
    assertThat(file.named()).containsKeys("Shape_1", "Shape_25", "StartView");
  }

  private static String node(String object, Room room, boolean enriched) {
    PlannedObject row = new PlannedObject(room, object, 1, new RoomPosition.Floor(1, -2, 90));
    PlacedObject placed = new PlacedObject(row, ParametricModel.of(object), 1, 0.5, -2, 90);
    X3dWriter xml = new X3dWriter();
    new ObjectNodeWriter(PolygonCounts.load(), ExpectancyRatings.load())
        .write(xml, placed, enriched);
    return xml.finish();
  }
}
