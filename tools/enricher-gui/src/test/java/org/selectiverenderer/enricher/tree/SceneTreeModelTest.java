package org.selectiverenderer.enricher.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.robot.TestSessions;

class SceneTreeModelTest {
  @TempDir Path folder;

  private SceneDocument scene() throws IOException {
    return TestSessions.with(
            folder,
            "<Group>" + TestSessions.object("Cup") + "</Group>" + TestSessions.object("Chair"))
        .document();
  }

  @Test
  void switchesAndSensorsAreAListAtFirst() throws IOException {
    SceneTreeModel model = new SceneTreeModel(scene());
    assertThat(model.getChildCount(model.getRoot())).isEqualTo(2);
    assertThat(model.isLeaf(model.getChild(model.getRoot(), 0))).isTrue();
  }

  @Test
  void searchFindsNamesInTheWholeScene() throws IOException {
    SceneTreeModel model = new SceneTreeModel(scene());
    model.showNodesOnly(false);
    model.search("inline");
    assertThat(model.getChildCount(model.getRoot())).isEqualTo(4);
    model.search("chair");
    assertThat(model.getChildCount(model.getRoot())).isEqualTo(1);
  }

  @Test
  void anElementWithinAnObjectIsShownByTheObjectInTheList() throws IOException {
    SceneDocument document = scene();
    SceneTreeModel model = new SceneTreeModel(document);
    var cup = document.tree().orElseThrow().named("Switch_Cup").orElseThrow();
    assertThat(model.path(cup.children().get(0)).orElseThrow().getLastPathComponent())
        .isSameAs(cup);
  }

  @Test
  void aBrokenTextKeepsTheLastGoodTree() throws IOException {
    SceneDocument document = scene();
    SceneTreeModel model = new SceneTreeModel(document);
    Object before = model.getRoot();
    document.type(0, 0, "<");
    model.refresh();
    assertThat(model.getRoot()).isSameAs(before);
    assertThat(model.getChildCount(model.getRoot())).isEqualTo(2);
    document.history().undo();
    model.refresh();
    assertThat(model.getRoot()).isNotSameAs(before);
  }

  @Test
  void aTextThatNeverWasWellFormedHasAnEmptyTree() throws IOException {
    SceneDocument document = TestSessions.with(folder, "<Group>").document();
    SceneTreeModel model = new SceneTreeModel(document);
    assertThat(model.getChildCount(model.getRoot())).isZero();
  }

  @Test
  void whatTheSearchOrTheExtentHidesIsNotShownButForWhatAnObjectHolds() throws IOException {
    SceneDocument document = scene();
    SceneTreeModel model = new SceneTreeModel(document);
    var cup = document.tree().orElseThrow().named("Switch_Cup").orElseThrow();
    var group = cup.parent().orElseThrow();
    assertThat(model.shows(cup.children().get(0))).as("in an object").isTrue();
    assertThat(model.shows(group)).as("neither object nor area").isFalse();
    model.search("chair");
    assertThat(model.hits()).hasSize(1);
    assertThat(model.shows(cup)).isFalse();
    model.search("");
    model.showNodesOnly(false);
    assertThat(model.hits()).isEmpty();
    assertThat(model.shows(group)).isTrue();
  }
}
