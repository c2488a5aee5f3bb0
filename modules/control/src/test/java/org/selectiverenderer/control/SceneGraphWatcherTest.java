package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.navigation.Collision;

class SceneGraphWatcherTest {
  private final List<X3DNode> found = new ArrayList<>();
  private final List<X3DNode> lost = new ArrayList<>();

  private SceneGraphWatcher walk(X3DExecutionContext scene) {
    SceneGraphWatcher walk =
        new SceneGraphWatcher(
            scene,
            null,
            UnaryOperator.identity(),
            null,
            Set.of("Group", "Transform", "Switch", "Collision"),
            new ListenerLock(this),
            (added, gone, time) -> {
              added.forEach(one -> found.add(one.node()));
              lost.addAll(gone);
            });
    walk.rescan(0);
    return walk;
  }

  @Test
  void nodesAreFoundInTheOrderOfTheScene() {
    try (var scene =
        new ControlledSceneFixture(
            "<Group DEF='A'><Transform DEF='B'/><Shape/></Group><Switch DEF='C'><Group DEF='D'/>"
                + "</Switch>")) {
      walk(scene.scene());

      assertThat(found)
          .containsExactly(scene.node("A"), scene.node("B"), scene.node("C"), scene.node("D"));
    }
  }

  @Test
  void fieldsOfAnyNameAreFollowed() {
    try (var scene =
        new ControlledSceneFixture(
            "<Collision DEF='A'><Group DEF='B' containerField='proxy'/></Collision>")) {
      walk(scene.scene());

      assertThat(found).containsExactly(scene.node("A"), scene.node("B"));
      assertThat(found.get(0)).isInstanceOf(Collision.class);
    }
  }

  @Test
  void aNodeInSeveralPlacesIsFoundOnceAndLostWithTheLast() {
    try (var scene =
        new ControlledSceneFixture(
            "<Group DEF='A'><Group DEF='X'/></Group><Group DEF='B'><Group USE='X'/></Group>")) {
      walk(scene.scene());
      X3DNode x = scene.node("X");
      assertThat(found).containsExactly(scene.node("A"), x, scene.node("B"));

      ((X3DGroupingNode) scene.node("A")).setChildren(new X3DNode[0]);
      scene.walkTo(0);
      assertThat(lost).isEmpty();
      ((X3DGroupingNode) scene.node("B")).setChildren(new X3DNode[0]);
      scene.walkTo(0);
      assertThat(lost).containsExactly(x);
    }
  }

  @Test
  void nodesThatHoldEachOtherEndTheWalk() {
    try (var scene = new ControlledSceneFixture("")) {
      X3DScene other = scene.browser.createScene(scene.browser.getProfile("Interchange"), null);
      X3DGroupingNode a = (X3DGroupingNode) other.createNode("Group");
      X3DGroupingNode b = (X3DGroupingNode) other.createNode("Group");
      a.setChildren(new X3DNode[] {b});
      b.setChildren(new X3DNode[] {a, b});
      other.addRootNode(a);

      walk(other);

      assertThat(found).containsExactly(a, b);
    }
  }

  @Test
  void afterClosingNothingIsHeard() {
    try (var scene = new ControlledSceneFixture("<Group DEF='A'><Group/></Group>")) {
      walk(scene.scene()).close();
      ((X3DGroupingNode) scene.node("A")).setChildren(new X3DNode[0]);
      scene.walkTo(0);

      assertThat(lost).isEmpty();
    }
  }
}
