package org.selectiverenderer.enricher.ratings;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.study.gaze.GazeSimulator;

class RatingsImportModelTest {
  private final EnrichmentScenes scene =
      EnrichmentScenes.with(
          TestSessions.object("Sink")
              + TestSessions.object("TrashCan")
              + TestSessions.object("Lamp"));
  private final RatingsImportModel model = new RatingsImportModel(scene.enrichment);

  private void read(String... rows) {
    String table = "object,schema,rating\n" + String.join("\n", rows) + "\n";
    model.take(RatingsImportModel.read("ratings.csv", table.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void meansAndBandsAndWhatFollowsAreShown() {
    read("Sink,Kitchen,6", "Sink,Kitchen,5", "TrashCan,Kitchen,2");
    ImpliedMetadataTableModel implied = new ImpliedMetadataTableModel(model);
    assertThat(implied.getValueAt(0, 2)).isEqualTo("5.50");
    assertThat(implied.getValueAt(0, 3)).isEqualTo("2");
    assertThat(implied.getValueAt(0, 4)).isEqualTo("expected, from 4");
    assertThat(implied.getValueAt(0, 5)).isEqualTo("version 2: consistent, high");
    assertThat(implied.getValueAt(1, 5)).isEqualTo("version 1: inconsistent, low");
  }

  @Test
  void ratingsAsAScaleChangeTheVersionAtOnce() {
    read("Sink,Kitchen,3.8", "TrashCan,Kitchen,3.2");
    ImpliedMetadataTableModel implied = new ImpliedMetadataTableModel(model);
    assertThat(implied.getValueAt(1, 5)).isEqualTo("version 2: consistent, high");
    model.scale(RatingScale.LINEAR);
    assertThat(implied.getValueAt(0, 5)).isEqualTo("version 2: consistent, high");
    assertThat(implied.getValueAt(1, 5)).isEqualTo("version 1: inconsistent, low");
  }

  @Test
  void ratingsAsAScaleHaveADegreeInPlaceOfABand() {
    read("Sink,Kitchen,3.5");
    ImpliedMetadataTableModel implied = new ImpliedMetadataTableModel(model);
    assertThat(implied.getValueAt(0, 4)).isEqualTo("neutral, 3 to 4");
    model.scale(RatingScale.LINEAR);
    assertThat(implied.getValueAt(0, 4)).isEqualTo("degree 0.50");
  }

  @Test
  void logsThatWereReadBeforeATableProposeAnew(@TempDir Path folder) throws IOException {
    ViewedObjects before = model.viewed();
    Path log = folder.resolve("a.csv");
    GazeSimulator room =
        new GazeSimulator("s.x3d", List.of("Kitchen"), GazeSimulator.along(new double[] {0, 1}, 1));
    GazeSimulator.write(room.log(20, 1), log);
    RatingsImportModel.Logs logs = RatingsImportModel.read(List.of(log), "s.x3d", before);
    read("Sink,Kitchen,9");
    int ofTable = model.problems().size();
    assertThat(ofTable).isPositive();
    model.take(logs);
    assertThat(model.takeGazeStale()).isTrue();
    assertThat(model.problems()).hasSize(ofTable + logs.problems().size());
    model.take(logs.read(), model.viewed(), logs.read().of(model.viewed()));
    assertThat(model.takeGazeStale()).isFalse();
    model.scale(RatingScale.LINEAR);
    assertThat(model.takeGazeStale()).isFalse(); // degrees do not depend on it
  }

  @Test
  void aSimilarNameIsAProposalUntilItIsChosen() {
    read("Sinc,Kitchen,6");
    MatchTableModel matches = new MatchTableModel(model);
    assertThat(matches.getValueAt(0, MatchTableModel.SWITCH)).isEqualTo("Switch_Sink");
    assertThat(model.applicable()).isFalse();
    assertThat(model.leftOut()).anyMatch(s -> s.contains("Sinc may be Switch_Sink"));
    model.acceptProposals();
    assertThat(model.applicable()).isTrue();
    assertThat(matches.getValueAt(0, 2)).isEqualTo("chosen");
  }

  @Test
  void aMatchCanBeCorrectedAndTakenBack() {
    read("Sink,Kitchen,6");
    MatchTableModel matches = new MatchTableModel(model);
    matches.setValueAt("Switch_TrashCan", 0, MatchTableModel.SWITCH);
    assertThat(model.plan().orElseThrow().rows().get(0).node().name()).isEqualTo("Switch_TrashCan");
    matches.setValueAt(MatchTableModel.none(), 0, MatchTableModel.SWITCH);
    assertThat(model.leftOut()).contains("Not used: Sink has no Switch");
  }

  @Test
  void objectsThatWereNotRatedAreToldOrFollowTheirRoom() {
    read("Sink,Kitchen,6", "TrashCan,Kitchen,2");
    assertThat(new ImpliedMetadataTableModel(model).getRowCount()).isEqualTo(3);
    model.unratedFollow(false);
    assertThat(model.leftOut()).containsExactly("Not rated: Switch_Lamp stays as it is");
  }

  @Test
  void aTableWithARatingThatIsNoneIsNotUsedAndSaysWhere() {
    read("Sink,Kitchen,7");
    assertThat(model.applicable()).isFalse();
    assertThat(model.edit()).isEqualTo(Optional.empty());
    assertThat(model.problems().get(0).toString()).startsWith("ratings.csv:2:");
    assertThat(model.summary()).contains("not used");
  }

  @Test
  void allIsAppliedAsOneStep() {
    read("Sink,Kitchen,6", "TrashCan,Kitchen,2");
    scene.perform(model.edit().orElseThrow());
    assertThat(scene.document.history().names()).containsExactly("Import ratings of ratings.csv");
    assertThat(scene.switchNode("Switch_Sink").choices().get(1).values().schemas())
        .containsExactly("Kitchen");
  }
}
