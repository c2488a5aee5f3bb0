package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class VersionsModelTest {
  private static final String SCENE =
      "<X3D version='4.0'><Scene><Transform DEF='Ball'><Shape><Appearance><Material"
          + " diffuseColor='1 0 0'/></Appearance><Sphere/></Shape></Transform></Scene></X3D>\n";

  @TempDir Path folder;

  private final VersionsModel model = new VersionsModel("Ball");

  private SceneDocument document() throws IOException {
    return DocumentFile.open(Files.writeString(folder.resolve("ball.x3d"), SCENE)).document();
  }

  private ComputedVersions compute() throws IOException {
    return ComputedVersions.of(
        document().snapshot(),
        new VersionsEdit.Request(
            folder.resolve("ball.x3d"),
            model.object(),
            model.goals().stream().<SimplificationTarget>map(VersionGoal::goal).toList(),
            "inlineNodes"),
        NodeCatalogue.load());
  }

  @Test
  void versionsAreWorkedOutAndNothingIsWritten() throws IOException {
    ComputedVersions computed = compute();
    model.take(model.wanted(), computed);
    assertThat(model.applicable()).isTrue();
    assertThat(computed.shapes()).hasSize(2).allMatch(shape -> shape.isPresent());
    ColoredMesh half = computed.shapes().get(1).orElseThrow();
    assertThat(half.polygons()).isEqualTo(computed.versions().get(1).polygons());
    assertThat(half.colors()[0]).isEqualTo(0xFF0000);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void versionsThatAreThereAreKeptUntilTheAuthorWantsOthers() throws IOException {
    SceneDocument document = document();
    compute().edit().orElseThrow().apply(document);
    Path second = folder.resolve("inlineNodes/Ball_v2.x3d");
    String byHand = "<X3D version='4.0'><Scene><Shape><Box/></Shape></Scene></X3D>";
    Files.writeString(second, byHand);
    VersionsEdit.Request request =
        new VersionsEdit.Request(
            folder.resolve("ball.x3d"),
            "Ball",
            List.of(new SimplificationTarget.VertexPercent(50)),
            "inlineNodes");
    NodeCatalogue catalogue = NodeCatalogue.load();
    model.take(model.wanted(), ComputedVersions.first(document.snapshot(), request, catalogue));
    assertThat(model.kept()).containsExactly(2);
    assertThat(model.current()).isTrue();
    assertThat(model.applicable()).as("nothing to do").isFalse();
    assertThat(model.result().orElseThrow().versions().get(1).polygons()).isEqualTo(12);
    model.add();
    assertThat(model.kept()).containsExactly(2);
    assertThat(model.goals().get(1).keeps()).isFalse();
    ComputedVersions more =
        ComputedVersions.of(
            document.snapshot(),
            new VersionsEdit.Request(
                    folder.resolve("ball.x3d"),
                    "Ball",
                    model.goals().stream().<SimplificationTarget>map(VersionGoal::goal).toList(),
                    "inlineNodes")
                .keeping(model.kept()),
            catalogue);
    more.edit().orElseThrow().apply(document);
    assertThat(second).hasContent(byHand);
    assertThat(folder.resolve("inlineNodes/Ball_v3.x3d")).exists();
  }

  @Test
  void aResultOfOlderGoalsIsShownButNotApplied() throws IOException {
    long number = model.wanted();
    ComputedVersions computed = compute();
    model.goal(0, VersionGoal.percent(25));
    model.take(number, computed);
    assertThat(model.result()).contains(computed);
    assertThat(model.applicable()).isFalse();
  }

  @Test
  void anOlderResultDoesNotReplaceANewerOne() throws IOException {
    long first = model.wanted();
    ComputedVersions old = compute();
    model.goal(0, VersionGoal.percent(25));
    ComputedVersions fresh = compute();
    model.take(model.wanted(), fresh);
    model.take(first, old);
    assertThat(model.result()).contains(fresh);
  }

  @Test
  void percentAndCountAreTheSameGoalSaidInTwoWays() {
    VersionGoal half = VersionGoal.percent(50);
    assertThat(half.as(VersionGoal.Kind.COUNT, 400).goal())
        .isEqualTo(new SimplificationTarget.Vertices(200));
    assertThat(half.as(VersionGoal.Kind.COUNT, 400).as(VersionGoal.Kind.PERCENT, 400))
        .isEqualTo(half);
  }

  @Test
  void aGoalStaysWithinWhatTheOriginalHas() throws IOException {
    model.take(model.wanted(), compute());
    model.goal(0, new VersionGoal(VersionGoal.Kind.COUNT, 1_000_000));
    assertThat(model.goals().get(0).value()).isEqualTo(model.maxVertex());
  }

  @Test
  void aFurtherVersionHasHalfOfTheOneBefore() {
    model.add();
    assertThat(model.goals()).containsExactly(VersionGoal.percent(50), VersionGoal.percent(25));
    model.removeLast();
    model.removeLast();
    assertThat(model.goals()).hasSize(1);
  }

  @Test
  void anObjectIsFoundAroundWhateverIsSelected() throws IOException {
    SceneDocument document = document();
    int sphere = document.text().toString().indexOf("<Sphere");
    assertThat(VersionsModel.nameOf(document.tree().orElseThrow().at(sphere).orElseThrow()))
        .isEqualTo("Ball");
    assertThat(VersionsModel.objects(document)).isEqualTo(List.of("Ball"));
  }

  @Test
  void anObjectThatCannotGetVersionsSaysWhy() throws IOException {
    model.object("Nothing");
    ComputedVersions computed = compute();
    model.take(model.wanted(), computed);
    assertThat(model.applicable()).isFalse();
    assertThat(computed.problems().get(0).message()).contains("no node with DEF 'Nothing'");
  }
}
