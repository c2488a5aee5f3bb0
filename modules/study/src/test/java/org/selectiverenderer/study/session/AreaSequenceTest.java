package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;

class AreaSequenceTest {
  @TempDir private Path folder;

  @Test
  void theGroupsHaveAllOrdersEquallyOften() throws IOException {
    Study study = material("counterbalanced").study();
    Map<String, Integer> orders = new HashMap<>();
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    for (int place = 1; place <= 36; place++) {
      List<String> order = names(study, "p" + place, AreaSequence.turn(study, place));
      orders.merge(schedule.group(place).name() + " " + order, 1, Integer::sum);
    }
    assertThat(orders).hasSize(3 * 6);
    assertThat(orders.values()).containsOnly(2);
  }

  @Test
  void aDrawnOrderIsTheParticipantsOwnAndAlwaysTheSame() throws IOException {
    Study study = material("random").study();
    Set<List<String>> orders = new HashSet<>();
    for (int i = 0; i < 60; i++) {
      List<String> order = names(study, "p" + i, 0);
      assertThat(order).containsExactlyInAnyOrder("hall", "bath", "attic");
      assertThat(names(study, "p" + i, 5)).isEqualTo(order);
      orders.add(order);
    }
    assertThat(orders).hasSize(6);
  }

  @Test
  void theOrderIsSaidOnceAndKeptWhenTheStudyHasAnotherOne() throws IOException {
    List<String> first;
    try (Session session =
        Session.begin(
            material("counterbalanced"),
            "001",
            1,
            TwoRoomStudyFixture.OPTIONS,
            new ProblemCollector())) {
      assertThat(TwoRoomStudyFixture.left(session))
          .containsExactly("form", "exposure-hall", "exposure-bath", "exposure-attic");
      TwoRoomStudyFixture.form(session);
      first = TwoRoomStudyFixture.left(session);
    }
    try (Session session =
        Session.begin(
            material("counterbalanced"),
            "002",
            1,
            TwoRoomStudyFixture.OPTIONS,
            new ProblemCollector())) {
      TwoRoomStudyFixture.form(session);
    }
    String events = Files.readString(folder.resolve("sub-001/ses-01/events.jsonl"));
    assertThat(events).containsOnlyOnce("\"event\":\"area-order\"");
    List<String> said = new ArrayList<>();
    first.forEach(step -> said.add('"' + step.substring("exposure-".length()) + '"'));
    assertThat(events)
        .contains("\"order\":\"counterbalanced\"", "\"areas\":[" + String.join(",", said) + "]");
    try (Session session =
        Session.resume(
            material("fixed"), "001", 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      assertThat(TwoRoomStudyFixture.left(session)).isEqualTo(first);
    }
  }

  private static List<String> names(Study study, String participant, int turn) {
    return AreaSequence.of(study, participant, turn).stream().map(Study.Area::name).toList();
  }

  private LoadedStudy material(String order) throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>");
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "conditions": ["high", "selective", "random"], "participants": 36,
             "scene": "rooms.x3d", "order": "%s", "seed": 4,
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1},
                       {"name": "bath", "viewpoint": "Here", "seconds": 1},
                       {"name": "attic", "viewpoint": "Here", "seconds": 1}]}
            """
                .formatted(order));
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }
}
