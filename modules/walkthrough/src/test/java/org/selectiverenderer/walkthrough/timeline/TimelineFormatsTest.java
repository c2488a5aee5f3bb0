package org.selectiverenderer.walkthrough.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SwitchVisibility;
import org.selectiverenderer.schema.Quality;

class TimelineFormatsTest {
  private final TimelineText text = new TimelineText();
  private final TimelineJson json = new TimelineJson();

  private static Map<String, Integer> switches(int count) {
    Map<String, Integer> switches = new LinkedHashMap<>();
    for (int i = 0; i < count; i++) {
      switches.put("S" + i, i % 2);
    }
    return switches;
  }

  private static TimelineEvent told(double t, ControlEvent event) {
    return new TimelineEvent.ControllerEvent(t, event);
  }

  @Test
  void theStartListsSwitchesInTheirOrder() {
    TimelineEvent start = told(0, new ControlEvent.Start(0, switches(3)));
    assertThat(json.line(start))
        .isEqualTo("{\"t\":0.0,\"event\":\"start\",\"switches\":{\"S0\":0,\"S1\":1,\"S2\":0}}");
    assertThat(text.line(start))
        .isEqualTo("   0.000 s  start   S0: choice 0, S1: choice 1, S2: choice 0");
  }

  @Test
  void veryManySwitchesAreCountedForPeopleAndListedForPrograms() {
    TimelineEvent start = told(0, new ControlEvent.Start(0, switches(21)));
    assertThat(text.line(start)).isEqualTo("   0.000 s  start   21 enriched switches");
    assertThat(json.line(start)).contains("\"S20\":0");
  }

  @Test
  void aSceneWithoutSchemasIsToldAtTheStart() {
    TimelineEvent start = told(0, new ControlEvent.Start(0, Map.of()));
    assertThat(text.line(start))
        .isEqualTo(
            "   0.000 s  start   no Switch of the scene has schema metadata, so "
                + "nothing will change");
    assertThat(json.line(start)).isEqualTo("{\"t\":0.0,\"event\":\"start\",\"switches\":{}}");
  }

  @Test
  void fieldsThatAreQualities() {
    TimelineEvent start =
        told(0, new ControlEvent.Start(0, switches(1), Map.of("Sofa", Map.of("T.url", -1))));
    TimelineEvent changed =
        told(2, new ControlEvent.FieldChange(0, "Sofa", Quality.TEXTURES, "T.url", -1, 1, "A"));
    assertThat(text.line(start)).isEqualTo("   0.000 s  start   S0: choice 0; 1 field with levels");
    assertThat(json.line(start))
        .isEqualTo(
            "{\"t\":0.0,\"event\":\"start\",\"switches\":{\"S0\":0},"
                + "\"fields\":{\"Sofa\":{\"T.url\":-1}}}");
    assertThat(text.line(changed))
        .isEqualTo("   2.000 s  field   Sofa: textures of T.url level -1 -> 1 (A)");
    assertThat(json.line(changed))
        .isEqualTo(
            "{\"t\":2.0,\"event\":\"field\",\"object\":\"Sofa\",\"quality\":\"textures\","
                + "\"field\":\"T.url\",\"from\":-1,\"to\":1,\"schema\":\"A\"}");
  }

  @Test
  void whatIsSeenOfAFieldIsToldAsOfASwitch() {
    TimelineEvent seen =
        told(
            2,
            new ControlEvent.FieldChange(
                0,
                "Sofa",
                Quality.TEXTURES,
                "T.url",
                0,
                1,
                "A",
                Optional.of(new SwitchVisibility(true, 812.4, 3.2))));
    assertThat(new TimelineText(true).line(seen))
        .isEqualTo(
            "   2.000 s  field   Sofa: textures of T.url level 0 -> 1 (A), 812 pixels seen, 3"
                + " degrees/s");
    assertThat(text.line(seen)).endsWith("level 0 -> 1 (A)");
  }

  @Test
  void theEndSumsTheLevelsOfFields() {
    TimelineEvent end =
        new TimelineEvent.End(
            5,
            301,
            new TimelineEvent.PolygonSpan(1, 1, 1),
            Map.of(),
            List.of(
                new QualityLevels(
                    Quality.TEXTURES,
                    2,
                    List.of(
                        new QualityLevels.Level(0, 7.5, 1), new QualityLevels.Level(1, 2.5, 1))),
                new QualityLevels(Quality.LIGHT, 1, List.of(new QualityLevels.Level(-1, 5, 1)))));
    assertThat(text.line(end))
        .isEqualTo(
            "   5.000 s  end     301 frames; 1 polygons at the start, 1 at the end, 1 at most;"
                + " textures of 2 fields: level 0 for 75 % of the time (1 field at the end),"
                + " level 1 for 25 % (1 field);"
                + " light of 1 field: no level for 100 % of the time (1 field at the end)");
    assertThat(json.line(end))
        .endsWith(
            "\"qualities\":{\"textures\":{\"fields\":2,\"levels\":["
                + "{\"level\":0,\"seconds\":7.5,\"end\":1},{\"level\":1,\"seconds\":2.5,\"end\":1}]},"
                + "\"light\":{\"fields\":1,\"levels\":[{\"level\":-1,\"seconds\":5.0,\"end\":1}]}}}");
  }

  @Test
  void areasSwitchesAndTheEnd() {
    TimelineEvent enter = told(1.25, new ControlEvent.Enter(0, "P", List.of("A", "B")));
    TimelineEvent exit = told(2, new ControlEvent.Exit(0, "P", List.of()));
    TimelineEvent switched = told(1.25, new ControlEvent.SwitchChange(0, "S", 1, 0, "A"));
    TimelineEvent end =
        new TimelineEvent.End(5, 301, new TimelineEvent.PolygonSpan(67003, 67003, 75648));
    assertThat(text.line(enter)).isEqualTo("   1.250 s  enter   P activates A, B");
    assertThat(text.line(exit)).isEqualTo("   2.000 s  exit    P (activates no schema)");
    assertThat(text.line(switched)).isEqualTo("   1.250 s  switch  S: choice 1 -> 0 (A)");
    assertThat(text.line(end))
        .isEqualTo(
            "   5.000 s  end     301 frames; 67003 polygons at the start, 67003 at the end, 75648"
                + " at most");
    assertThat(json.line(enter))
        .isEqualTo("{\"t\":1.25,\"event\":\"enter\",\"sensor\":\"P\",\"schemas\":[\"A\",\"B\"]}");
    assertThat(json.line(exit))
        .isEqualTo("{\"t\":2.0,\"event\":\"exit\",\"sensor\":\"P\",\"schemas\":[]}");
    assertThat(json.line(switched))
        .isEqualTo(
            "{\"t\":1.25,\"event\":\"switch\",\"switch\":\"S\",\"from\":1,\"to\":0,\"schema\":\"A\"}");
    assertThat(json.line(end))
        .isEqualTo(
            "{\"t\":5.0,\"event\":\"end\",\"frames\":301,\"polygons\":{\"start\":67003,\"end\":67003,"
                + "\"max\":75648}}");
  }

  @Test
  void timesAreRoundedToMicroseconds() {
    assertThat(json.line(told(1 / 3.0, new ControlEvent.Exit(0, "P", List.of()))))
        .startsWith("{\"t\":0.333333,");
  }
}
