package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher;
import org.selectiverenderer.authoring.ratings.RatingPlan;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.SensorSchemas;

/** A name is written so that it is read as it was, or it is refused; it is never altered. */
class SchemaNameRoundTripTest {
  private static final String NODES =
      "<Switch DEF='Switch_A'><Shape/><Shape/></Switch>\n<ProximitySensor DEF='Prox'/>\n";

  private final EnrichmentScenes scene = EnrichmentScenes.with(NODES);
  private final ProblemCollector problems = new ProblemCollector();

  /** The same scene, opened again from what was written. */
  private EnrichmentScenes again() {
    return EnrichmentScenes.of(scene.document.text().toString());
  }

  private static String cell(String name) {
    return '"' + name.replace("\"", "\"\"") + '"';
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "5\" desk",
        "\"",
        "O'Neill's \"den\"",
        "back\\slash\\",
        "a, b",
        "<&;>",
        "#",
        "\"a\" \"b\""
      })
  void namesOfAllKindsAreKeptByEveryWay(String name) {
    scene.perform(
        scene
            .edits()
            .all(
                "form",
                List.of(),
                List.of(
                    new EnrichmentEdits.SensorMetadata(
                        scene.sensor("Prox"),
                        new SensorSchemas(List.of(name, "Other"), List.of("Room"))))));
    assertThat(again().sensor("Prox").schemas().enter()).containsExactly(name, "Other");

    scene.perform(scene.edits().renameSchema("Room", name + "2"));
    assertThat(again().sensor("Prox").schemas().exit()).containsExactly(name + "2");

    scene.perform(
        MetadataTable.edit(
                scene.enrichment,
                "m.csv",
                bytes(
                    "node,choice,field,value\nSwitch_A,0,schemaBelonginess,%s\n"
                        .formatted(cell(name))),
                problems)
            .orElseThrow());
    assertThat(again().switchNode("Switch_A").values().get(0).schemas()).containsExactly(name);

    Ratings ratings =
        Ratings.read(
                "r.csv", bytes("object,schema,rating\nA,%s,6\n".formatted(cell(name))), problems)
            .orElseThrow();
    scene.perform(
        RatingPlan.of(
                scene.enrichment,
                ratings,
                new ObjectNameMatcher(ratings.means().keySet(), scene.enrichment.switches()),
                true,
                RatingScale.BANDS)
            .edit("ratings"));
    assertThat(again().switchNode("Switch_A").values().get(1).schemas()).containsExactly(name);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aNameThatNoSceneCanHoldIsRefusedWithItsReason() {
    assertThatThrownBy(() -> scene.edits().renameSchema("Room", "De\u0001sk"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("cannot be written");
    Optional<?> edit =
        MetadataTable.edit(
            scene.enrichment,
            "m.csv",
            bytes("node,choice,field,value\nProx,,enterTimeSchemaActivation,\"De\nsk\"\n"),
            problems);
    assertThat(edit).isEmpty();
    assertThat(problems.list().get(0).toString()).contains("m.csv:2:");
    assertThat(scene.document.history().names()).isEmpty();
  }
}
