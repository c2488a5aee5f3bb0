package org.selectiverenderer.browser.nodes.group;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.scene.Node;

class GroupingNodesTest {
  private static final Vector3d UP = new Vector3d(0, 1, 0);
  private final TestNodes nodes = new TestNodes();

  @ParameterizedTest
  @ValueSource(ints = {-1, 2, Integer.MAX_VALUE, Integer.MIN_VALUE})
  void aChoiceThatIsNoChildShowsNothing(int choice) {
    SwitchNode node =
        (SwitchNode)
            nodes.node(
                "Switch", "whichChoice", choice, "children", List.of(nodes.shape(), nodes.shape()));
    assertThat(node.shows(0)).isFalse();
    assertThat(node.shows(1)).isFalse();
  }

  @Test
  void childrenAreAddedOnceAndRemovedWhereTheyAre() {
    Node a = nodes.shape();
    Node b = nodes.shape();
    Node c = nodes.shape();
    GroupingNode group = (GroupingNode) nodes.watch(nodes.group(a), "children");
    nodes.send(group, "addChildren", List.of(a, b, b));
    assertThat(group.children()).containsExactly(a, b);
    nodes.send(group, "removeChildren", List.of(a, c));
    assertThat(group.children()).containsExactly(b);
    nodes.sent();
    nodes.send(group, "addChildren", List.of(b));
    nodes.send(group, "removeChildren", List.of(c));
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aTransformScalesAboutItsCenterAlongItsScaleOrientation() {
    TransformNode transform =
        (TransformNode)
            nodes.node(
                "Transform",
                "translation",
                new float[] {10, 0, 0},
                "center",
                new float[] {1, 0, 0},
                "scale",
                new float[] {2, 1, 1},
                "scaleOrientation",
                new float[] {0, 0, 2, (float) Math.PI / 2},
                "rotation",
                new float[] {0, 0, 1, (float) Math.PI / 2});
    // (1, 3, 0) is 3 above the center; the scale's X axis points up there: 6; turned left: -6.
    Vector3d moved = transform.placement().orElseThrow().transformPosition(new Vector3d(1, 3, 0));
    assertThat(moved.distance(5, 0, 0)).isLessThan(1e-6);
  }

  @Test
  void aRotationAboutNoAxisIsNone() {
    TransformNode transform =
        (TransformNode) nodes.node("Transform", "rotation", new float[] {0, 0, 0, 1});
    assertThat(transform.placement().orElseThrow()).isEqualTo(new Matrix4d());
  }

  @ParameterizedTest
  @CsvSource({"0,0", "4.9,0", "5,1", "9.9,1", "10,2", "1e9,2"})
  void levelsOfDetailChangeAtTheirDistances(double distance, int level) {
    LodNode lod =
        (LodNode)
            nodes.watch(
                nodes.node(
                    "LOD",
                    "range",
                    new float[] {5, 10},
                    "children",
                    List.of(nodes.shape(), nodes.shape(), nodes.shape())),
                "level_changed");
    lod.view(new Vector3d(0, 0, distance), UP, nodes.cascade);
    lod.view(new Vector3d(0, 0, distance), UP, nodes.cascade);
    assertThat(lod.shows(level)).isTrue();
    assertThat(nodes.sent()).hasSize(level == 0 ? 0 : 1);
  }

  @Test
  void aLevelWithoutAChildShowsTheLastChild() {
    LodNode lod =
        (LodNode)
            nodes.node("LOD", "range", new float[] {5, 10}, "children", List.of(nodes.shape()));
    lod.view(new Vector3d(0, 0, 50), UP, nodes.cascade);
    assertThat(lod.shows(0)).isTrue();
  }

  private Matrix4d billboard(float[] axis, Vector3d viewer, Vector3d up) {
    BillboardNode node = (BillboardNode) nodes.node("Billboard", "axisOfRotation", axis);
    node.view(viewer, up, nodes.cascade);
    return node.placement().orElseThrow();
  }

  @Test
  void aBillboardTurnsAboutItsAxisOnly() {
    Matrix4d m = billboard(new float[] {0, 3, 0}, new Vector3d(5, 99, 0), UP);
    assertThat(m.transformDirection(new Vector3d(0, 0, 1)).distance(1, 0, 0)).isLessThan(1e-9);
    assertThat(m.transformDirection(new Vector3d(0, 1, 0)).distance(0, 1, 0)).isLessThan(1e-9);
  }

  @Test
  void aFreeBillboardFacesTheViewerAndFollowsItsUp() {
    Vector3d tilted = new Vector3d(1, 1, 0);
    Matrix4d m = billboard(new float[3], new Vector3d(0, 0, 7), tilted);
    assertThat(m.transformDirection(new Vector3d(0, 0, 1)).distance(0, 0, 1)).isLessThan(1e-9);
    Vector3d up = m.transformDirection(new Vector3d(0, 1, 0));
    assertThat(up.distance(tilted.normalize(new Vector3d()))).isLessThan(1e-9);
  }

  @Test
  void aBillboardThatCannotFaceTheViewerStaysAsItIs() {
    assertThat(billboard(new float[3], new Vector3d(), UP)).isEqualTo(new Matrix4d());
    assertThat(billboard(new float[3], new Vector3d(0, 5, 0), UP)).isEqualTo(new Matrix4d());
    assertThat(billboard(new float[] {0, 1, 0}, new Vector3d(0, 5, 0), UP))
        .isEqualTo(new Matrix4d());
  }
}
