package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.schema.TestMetadataNode.choice;
import static org.selectiverenderer.schema.TestMetadataNode.named;
import static org.selectiverenderer.schema.TestMetadataNode.set;
import static org.selectiverenderer.schema.TestMetadataNode.string;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.SchemaProblem.Kind;

class FieldQualitiesTest {
  private final List<SchemaProblem> problems = new ArrayList<>();
  private final SchemaReader reader = new SchemaReader(problems::add);

  private static TestMetadataNode level(String degree, String schema, String... values) {
    return set(
        string("degreeOfConsistency", degree),
        string("schemaBelonginess", schema),
        string("value", values));
  }

  private static TestMetadataNode textures(String field) {
    return set(
        string("quality", "textures"),
        string("field", field),
        level("low", "hall", "sofa.jpg"),
        level("high", "kitchen", "sofa_25.jpg"));
  }

  private static TestMetadataNode object(TestMetadataNode... qualities) {
    return set(choice("consistent", "high", "kitchen"), choice("consistent", "low", "hall"))
        .with(named("fieldQualities", qualities));
  }

  private List<Kind> kinds() {
    return problems.stream().map(SchemaProblem::kind).toList();
  }

  @Test
  void qualitiesStandInTheMetadataOfTheMetadataBesideTheChoices() {
    TestMetadataNode sofa = object(textures("Sofa.Texture.url"));
    assertThat(reader.switchNode(sofa, 2).orElseThrow().choices()).hasSize(2);
    List<FieldQuality> qualities = reader.fieldQualities(sofa);
    assertThat(problems).isEmpty();
    FieldQuality only = qualities.get(0);
    assertThat(only.quality()).isEqualTo(Quality.TEXTURES);
    assertThat(only.target()).isEqualTo(new FieldReference("Sofa.Texture", "url"));
    assertThat(only.levels())
        .extracting(FieldLevel::values)
        .containsExactly(List.of("sofa.jpg"), List.of("sofa_25.jpg"));
    assertThat(only.schemas().choiceBySchema()).isEqualTo(Map.of("hall", 0, "kitchen", 1));
  }

  @Test
  void aSetAmongOtherMetadataOfTheMetadataIsFoundToo() {
    TestMetadataNode sofa =
        set().with(set(string("author", "A."), named("fieldQualities", textures("T.url"))));
    assertThat(reader.fieldQualities(sofa)).hasSize(1);
    assertThat(reader.switchNode(sofa, 1)).isEmpty();
  }

  @Test
  void eachConditionChoosesALevelAsItChoosesAVersion() {
    SwitchSchemas levels = reader.fieldQualities(object(textures("T.url"))).get(0).schemas();
    Map<String, SwitchSchemas> all = Map.of("T.url", levels);
    Set<String> activated = Set.of("hall", "kitchen");
    assertThat(Condition.HIGH.initialChoices(all, activated, 0)).containsEntry("T.url", 0);
    assertThat(Condition.HIGH_LOW.initialChoices(all, Set.of("kitchen"), 0))
        .containsEntry("T.url", 1);
    assertThat(QualityRule.LOW.choice(levels)).isEqualTo(1);
    assertThat(QualityRule.HIGH.choice(levels)).isZero();
  }

  @Test
  void wrongMetadataAreReportedAndPassedOver() {
    TestMetadataNode wrong =
        object(
            set(string("quality", "texture"), string("field", "A.url"), level("low", "a", "x")),
            set(string("quality", "light"), string("field", "nodot"), level("low", "a", "x")),
            set(string("quality", "light"), string("field", "B.on")),
            set(string("field", "C.on"), level("low", "a", "true")),
            textures("T.url"),
            textures("T.url"),
            set(
                string("quality", "light"),
                string("field", "D.on"),
                choice("consistent", "low", "a")));
    assertThat(reader.fieldQualities(wrong))
        .extracting(q -> q.target().toString())
        .containsExactly("T.url");
    assertThat(kinds())
        .containsExactly(
            Kind.UNKNOWN_QUALITY,
            Kind.UNKNOWN_FIELD,
            Kind.NO_VALUE,
            Kind.UNKNOWN_QUALITY,
            Kind.FIELD_TWICE,
            Kind.NO_VALUE,
            Kind.NO_VALUE);
  }

  @Test
  void levelsWithoutSchemasFollowTheVersionsByTheNearestDegree() {
    TestMetadataNode three =
        set(
            string("quality", "textures"),
            string("field", "T.url"),
            set(string("value", "a")),
            set(string("value", "b")),
            set(string("value", "c")));
    TestMetadataNode sofa =
        set(
                choice("consistent", "high", "kitchen"),
                choice("inconsistent", "low", "hall"),
                choice("consistent", "0.6", "bath"))
            .with(named("fieldQualities", three));
    assertThat(reader.fieldQualities(sofa).get(0).schemas().choiceBySchema())
        .isEqualTo(Map.of("kitchen", 2, "hall", 0, "bath", 1));
    assertThat(problems).isEmpty();
  }

  @Test
  void levelsThatNothingActivatesAreReportedOnce() {
    TestMetadataNode sofa =
        set()
            .with(
                named(
                    "fieldQualities",
                    set(
                        string("quality", "textures"),
                        string("field", "T.url"),
                        set(string("value", "a")),
                        set(string("value", "b")))));
    SwitchSchemas levels = reader.fieldQualities(sofa).get(0).schemas();
    assertThat(levels.mostDetailed()).isZero();
    assertThat(levels.leastDetailed()).isEqualTo(1);
    assertThat(kinds()).containsExactly(Kind.NO_SCHEMA);
  }

  @Test
  void anEmptyListIsAValue() {
    TestMetadataNode sofa =
        object(
            set(
                string("quality", "light"),
                string("field", "T.url"),
                level("low", "a", "light.png"),
                level("high", "b")));
    assertThat(reader.fieldQualities(sofa).get(0).levels().get(1).values()).isEmpty();
    assertThat(problems).isEmpty();
  }

  @Test
  void theVersionsOfASwitchMaySayInWhatTheyDiffer() {
    TestMetadataNode plain = set(choice("consistent", "low", "a"));
    assertThat(reader.switchNode(plain, 1).orElseThrow().quality()).isEqualTo(Quality.POLYGONS);
    TestMetadataNode lit =
        set(
            set(string("quality", " Light "), string("schemaBelonginess", "a")),
            set(string("schemaBelonginess", "b")));
    assertThat(reader.switchNode(lit, 2).orElseThrow().quality()).isEqualTo(Quality.LIGHT);
    assertThat(problems).isEmpty();
    TestMetadataNode mixed =
        set(
            set(string("quality", "light"), string("schemaBelonginess", "a")),
            set(string("quality", "shading"), string("schemaBelonginess", "b")));
    assertThat(reader.switchNode(mixed, 2).orElseThrow().quality()).isEqualTo(Quality.LIGHT);
    assertThat(kinds()).containsExactly(Kind.SEVERAL_QUALITIES);
  }
}
