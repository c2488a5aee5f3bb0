package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.selectiverenderer.polygon.SmallScene.area;
import static org.selectiverenderer.polygon.SmallScene.count;
import static org.selectiverenderer.polygon.SmallScene.object;
import static org.selectiverenderer.polygon.SmallScene.shape;
import static org.selectiverenderer.polygon.SmallScene.states;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

class ScenePolygonCounterTest {
  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  @Test
  void highIsEveryObjectAtItsMostDetailedAndWhatHasOneVersion() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<Group DEF='Room'>",
            shape(5),
            object("Switch_A", "Desk:100", "Office:10"),
            object("Switch_B", "Desk:200", "Office:20"),
            "</Group>",
            shape(7));

    assertThat(scene.totalHigh()).isEqualTo(312);
    assertThat(scene.scopes()).extracting(ScopeCount::high).containsExactly(305L);
    assertThat(states(scene.scopes().get(0))).containsExactly("Office=35");
    assertThat(scene.objects())
        .containsExactly(
            new ObjectCount("Switch_A", Optional.of("Room"), List.of(100L, 10L), 0),
            new ObjectCount("Switch_B", Optional.of("Room"), List.of(200L, 20L), 0));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void everyAreaAndEverySetOfOverlappingAreasIsAState() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<Group DEF='Room'>",
            object("Switch_A", "A:100", "Room:1"),
            object("Switch_B", "B:200", "Room:1"),
            object("Switch_C", "C:400", "Room:1"),
            area("A", "Room", 0),
            area("B", "Room", 1.5),
            area("C", "Room", 3),
            "</Group>");

    assertThat(states(scene.scopes().get(0)))
        .containsExactly("Room=3", "A=102", "B=202", "C=402", "A+B=301", "B+C=601");
  }

  @Test
  void ordersOfEnteringThatDifferAreStatesOfTheirOwn() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            object("Switch_A", "A:100", "B:30", "Room:1"),
            area("A", "Room", 0),
            area("B", "Room", 1));

    assertThat(states(scene.scopes().get(0)))
        .containsExactly("Room=1", "A=100", "B=30", "A+B=30", "B+A=100");
  }

  @Test
  void anAreaLiesInTheScopeAroundItsCentreOrAroundItsSensor() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<Transform DEF='Left' translation='-5 0 0'><Shape><Box size='9 9 9'/></Shape>",
            object("Switch_L1", "A:100", "L:1"),
            object("Switch_L2", "C:100", "L:1"),
            "</Transform>",
            "<Transform DEF='Right' translation='5 0 0'><Shape><Box size='9 9 9'/></Shape>",
            object("Switch_R1", "B:100", "R:1"),
            object("Switch_R2", "B:100", "R:1"),
            area("C", "R", -10), // stands here, though it is in the other room
            "</Transform>",
            area("A", "L", -5),
            area("B", "R", 4));

    assertThat(states(scene.scopes().get(0))).containsExactly("L=14", "A=113");
    assertThat(states(scene.scopes().get(1))).containsExactly("R=14", "C=14", "B=212");
  }

  @Test
  void anAreaAroundNoScopeBelongsToThoseWhoseObjectsItTurns() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<Group DEF='Room'>",
            object("Switch_A", "A:100", "Room:1"),
            "</Group>",
            area("A", "Room", 50),
            area("Other", "Room", 60));

    assertThat(states(scene.scopes().get(0))).containsExactly("Room=1", "A=100");
  }

  @Test
  void sensorsThatNobodyCanEnterAreNoAreas() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            object("Switch_A", "A:100", "Room:1"),
            area("A", "Room", "size='0 2 2'"),
            area("A", "Room", "size='2 2 2' enabled='false'"),
            "<Transform scale='1 0 1'>" + area("A", "Room", 0) + "</Transform>");

    assertThat(states(scene.scopes().get(0))).containsExactly("Room=1");
  }

  @Test
  void groupsThatEachPlaceOneObjectAreNoScopes() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<Transform DEF='PlaceA'>" + object("Switch_A", "A:9", "R:1") + "</Transform>",
            "<Transform DEF='PlaceB'>" + object("Switch_B", "A:8", "R:1") + "</Transform>");

    assertThat(scene.scopes()).extracting(ScopeCount::scope).containsExactly("scene");
    assertThat(scene.objects()).extracting(ObjectCount::scope).containsOnly(Optional.of("scene"));
  }

  @Test
  void whatStandsInLayersCounts() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            "<LayerSet activeLayer='1' order='1 2'>",
            "<Layer><Group DEF='Room'>",
            object("Switch_A", "Desk:20", "Office:3") + shape(5),
            "</Group></Layer>",
            "<Layer>" + shape(7) + "</Layer>",
            "</LayerSet>");
    assertThat(problems.list()).isEmpty();
    assertThat(scene.totalHigh()).isEqualTo(32);
    assertThat(scene.objects()).extracting(ObjectCount::switchName).containsExactly("Switch_A");
    assertThat(scene.scopes()).extracting(ScopeCount::high).containsExactly(25L);
  }

  @Test
  void anObjectThatIsUsedTwiceCountsTwice() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            object("Switch_A", "A:9", "R:2"),
            "<Transform translation='3 0 0'><Switch USE='Switch_A'/></Transform>");

    assertThat(scene.totalHigh()).isEqualTo(18);
    assertThat(scene.objects()).hasSize(1);
    assertThat(states(scene.scopes().get(0))).containsExactly("R=4");
  }

  @Test
  void withoutPolygonsNothingIsDividedByZero() throws IOException {
    SceneStatistics scene =
        count(
            folder,
            problems,
            object("Switch_A", "A:1", "R:1").replaceAll("<Shape>.*?</Shape>", "<Group/>"));

    assertThat(scene.totalHigh()).isZero();
    assertThat(scene.scopes().get(0).states().get(0).percent()).isZero();
    assertThat(scene.objects().get(0).percent(1)).isZero();
    assertThat(SceneStatisticsTextWriter.of(scene)).doesNotContain("NaN").contains("-");
    assertThat(SceneStatisticsJsonWriter.of(scene)).contains("\"percent\" : 0.0");
  }

  @Test
  void aSceneWithoutVersionsIsCountedAndSaysSo() throws IOException {
    SceneStatistics scene = count(folder, problems, shape(3));

    assertThat(scene.totalHigh()).isEqualTo(3);
    assertThat(problems.any()).isFalse();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "no Switch has schema metadata, so there are no versions to compare; the "
                + "polygons that the scene shows are counted");
  }

  @Test
  void aMissingInlineIsReportedWithItsPlaceAndTheRestIsCounted() throws IOException {
    SceneStatistics scene =
        count(folder, problems, shape(3), "<Inline url='\"nowhere.x3d\"'/>", shape(4));

    assertThat(scene.totalHigh()).isEqualTo(7);
    assertThat(problems.any()).isTrue();
    assertThat(problems.list().get(0).toString())
        .contains("scene.x3d:4:")
        .endsWith("Inline url 'nowhere.x3d' is missing; the Inline is left out");
  }

  @Test
  void aSceneThatInlinesItselfEnds() throws IOException {
    SceneStatistics scene = count(folder, problems, shape(3), "<Inline url='\"scene.x3d\"'/>");

    assertThat(scene.totalHigh()).isEqualTo(3);
    assertThat(problems.list()).extracting(Problem::message).anyMatch(m -> m.contains("itself"));
  }

  @Test
  void usesWithinUsesDoNotOverflow() throws IOException {
    StringBuilder nested = new StringBuilder("<Group DEF='G0'>" + shape(1000) + "</Group>");
    for (int i = 1; i < 80; i++) {
      nested.append(
          "<Group DEF='G%d'><Group USE='G%2$d'/><Group USE='G%2$d'/></Group>".formatted(i, i - 1));
    }

    assertThat(count(folder, problems, nested.toString()).totalHigh()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void objectsAndAreasOfInlinedFilesCount() throws IOException {
    Files.writeString(
        folder.resolve("part.x3d"),
        SmallScene.document("<Group DEF='Room'>", object("Switch_A", "A:9", "R:2"), "</Group>"));
    Files.writeString(folder.resolve("area.x3d"), SmallScene.document(area("A", "R", 0)));
    String[] building = {
      "<Inline url='\"area.x3d\"'/>",
      "<Inline url='\"part.x3d\"'/><Transform><Inline url='\"part.x3d\"'/></Transform>"
    };

    SceneStatistics scene = count(folder, problems, building);

    assertThat(scene.objects()).extracting(ObjectCount::switchName).containsExactly("Switch_A");
    assertThat(scene.totalHigh()).as("the same object in two places").isEqualTo(18);
    assertThat(scene.scopes()).extracting(ScopeCount::scope).containsExactly("Room");
    assertThat(scene.scopes().get(0).states())
        .extracting(StateCount::schemas)
        .containsExactly(List.of("R"), List.of("A"));
    Path file = folder.resolve("scene.x3d");
    assertThat(ScenePolygonCounter.of(file, List.of("Room"), problems).scopes()).hasSize(1);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void objectsOfOneNameInSeveralFilesAreToldApart() throws IOException {
    Files.writeString(
        folder.resolve("part.x3d"), SmallScene.document(object("Switch_A", "A:9", "R:2")));

    SceneStatistics scene =
        count(
            folder,
            problems,
            object("Switch_A", "A:9", "R:2"),
            "<Inline DEF='Room' url='\"part.x3d\"'/>");

    assertThat(scene.objects())
        .extracting(ObjectCount::switchName)
        .containsExactlyInAnyOrder("Switch_A", "Room/Switch_A");
  }

  @Test
  void badMetadataIsReportedWithItsPlace() throws IOException {
    count(folder, problems, object("Switch_A", "A:9", "R:1").replace("\"low\"", "\"lowish\""));

    assertThat(problems.list().get(0).toString()).contains("scene.x3d:2:", "Switch_A: ", "lowish");
  }

  @Test
  void scopesAreTakenByNameInTheOrderAsked() throws IOException {
    Path file =
        SmallScene.write(
            folder,
            "<Group DEF='One'>" + shape(1) + "</Group>",
            "<Group DEF='Two'>" + shape(2) + "</Group>");

    SceneStatistics scene = ScenePolygonCounter.of(file, List.of("Two", "One", "Two"), problems);

    assertThat(scene.scopes()).extracting(ScopeCount::scope).containsExactly("Two", "One");
    assertThat(scene.scopes()).extracting(ScopeCount::high).containsExactly(2L, 1L);
  }

  @Test
  void aScopeThatIsNotThereIsRefusedWithTheNearestName() throws IOException {
    Path file =
        SmallScene.write(
            folder, "<Group DEF='Office'>" + shape(1) + "</Group>", "<Viewpoint DEF='View'/>");

    assertThatThrownBy(() -> ScenePolygonCounter.of(file, List.of("Ofice"), problems))
        .isInstanceOf(UnknownRegionException.class)
        .hasMessage("the scene has no group 'Ofice'; did you mean Office?");
    assertThatThrownBy(() -> ScenePolygonCounter.of(file, List.of("View"), problems))
        .isInstanceOf(UnknownRegionException.class)
        .hasMessageContaining("scene.x3d:4:")
        .hasMessageEndingWith("View is a Viewpoint, not a group");
  }

  @Test
  void placesThatAreLeftOutAreSaid() throws IOException {
    StringBuilder sensors = new StringBuilder();
    for (int i = 0; i <= InstanceTransforms.LIMIT / 100; i++) {
      sensors.append("<Transform translation='").append(i).append(" 0 0'>");
      sensors.append(i == 0 ? "<Group DEF='Many'>" : "<Group USE='Many'/></Transform>");
      if (i == 0) {
        sensors.append(area("A", "B", 0).repeat(100)).append("</Group></Transform>");
      }
    }
    count(folder, problems, sensors.toString());

    assertThat(problems.list().toString()).contains("more than 10000 places");
  }

  @Test
  void aBrokenFileIsToldWithTheInlineThatNamesIt() throws IOException {
    Files.writeString(folder.resolve("broken.x3d"), "no scene");
    count(folder, problems, "<Inline url='\"broken.x3d\"'/><Inline url='\"broken.x3d\"'/>");

    assertThat(problems.list())
        .extracting(Problem::message)
        .first()
        .asString()
        .contains("neither XML nor VRML nor JSON")
        .containsPattern("\\(the Inline at [^ ]*x3d:[0-9]+:[0-9]+ names this file\\)$");
  }
}
