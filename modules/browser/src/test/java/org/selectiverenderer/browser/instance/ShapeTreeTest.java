package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;

class ShapeTreeTest {
  private static final int SHAPES = 5_000;
  private final TestNodes nodes = new TestNodes();
  private final List<Node> places = new ArrayList<>();
  private final Node root;
  private final InstanceTree tree;

  /** A row of boxes of half a metre at 0, 1, 2 ... metres. */
  ShapeTreeTest() {
    for (int i = 0; i < SHAPES; i++) {
      places.add(place(i));
    }
    root = nodes.group(places.toArray(Node[]::new));
    tree = new InstanceTree((GroupingNode) root, new CountingAssetProvider());
  }

  private Node place(float x) {
    Node box = nodes.node("Box", "size", new float[] {0.5f, 0.5f, 0.5f});
    Node shape = nodes.node("Shape", "geometry", box);
    return nodes.node(
        "Transform", "translation", new float[] {x, 0, 0}, "children", List.of(shape));
  }

  private BitSet at(double x) {
    BitSet found = new BitSet();
    tree.boxes().search((boxes, at, leaf) -> boxes[at] <= x && x <= boxes[at + 3], found::set);
    return found;
  }

  @Test
  void whatWasBegunIsSearched() {
    tree.boxes().begin();
    assertThat(at(4_321).get(4_321)).isTrue();
    assertThat(at(4_321).cardinality()).isLessThan(10);
  }

  @Test
  void aShapeThatMovesWhileItIsBuiltIsFoundWhereItIs() {
    tree.boxes().begin();
    nodes.send(places.get(7), "translation", new float[] {-50, 0, 0});
    tree.update();
    assertThat(at(-50).get(7)).isTrue();
    assertThat(at(SHAPES - 1).get(SHAPES - 1)).isTrue();
  }

  @Test
  void aShapeThatComesWhileItIsBuiltIsFound() {
    tree.boxes().begin();
    nodes.send(root, "addChildren", List.of(place(-70)));
    tree.update();
    assertThat(at(-70).get(SHAPES)).isTrue();
    tree.boxes().begin();
    assertThat(at(3).get(3)).isTrue();
  }
}
