package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;

/** Random edits of a scene, several between updates, against a tree that is built afresh. */
class InstanceTreeRandomTest {
  private final TestNodes nodes = new TestNodes();
  private final CountingAssetProvider assets = new CountingAssetProvider();
  private final List<Node> groups = new ArrayList<>();
  private final List<Node> shapes = new ArrayList<>();

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void theTreeStaysTrueToTheScene(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < 12; i++) {
      shapes.add(
          nodes.node("Shape", "geometry", nodes.node("Box", "size", new float[] {i + 1, 1, 1})));
    }
    for (int i = 0; i < 12; i++) {
      groups.add(nodes.node(List.of("Group", "Switch", "Transform").get(i % 3)));
    }
    InstanceTree tree = new InstanceTree((GroupingNode) groups.get(0), assets);
    for (int round = 0; round < 200; round++) {
      Map<ShapeInstance, String> before = states(tree);
      long read = tree.changes().end();
      for (int edits = random.nextInt(4); edits >= 0; edits--) {
        edit(random);
      }
      tree.update();
      compare(tree, new InstanceTree((GroupingNode) groups.get(0), assets));
      logged(tree, before, tree.changes().since(read));
      searched(tree, random.nextInt(60));
    }
  }

  private static Map<ShapeInstance, String> states(InstanceTree tree) {
    Map<ShapeInstance, String> states = new IdentityHashMap<>();
    for (ShapeInstance shape : tree.shapes()) {
      states.put(shape, state(shape));
    }
    return states;
  }

  private static String state(ShapeInstance shape) {
    return shape.shown()
        + Arrays.toString(shape.bounds())
        + System.identityHashCode(shape.mesh().orElse(null));
  }

  /** A shape that changed, and was not only hidden, is in the log, or the log knows of nothing. */
  private static void logged(
      InstanceTree tree, Map<ShapeInstance, String> before, Optional<List<ShapeInstance>> changes) {
    for (ShapeInstance shape : tree.shapes()) {
      assertThat(tree.shapes().get(shape.index())).isSameAs(shape);
      boolean hidden =
          !shape.shown() && ("true" + state(shape).substring(5)).equals(before.get(shape));
      if (changes.isPresent() && !hidden && !state(shape).equals(before.get(shape))) {
        assertThat(changes.get()).contains(shape);
      }
    }
  }

  /** A search reports what a plane of X cuts. */
  private static void searched(InstanceTree tree, int x) {
    BitSet found = new BitSet();
    tree.boxes().search((boxes, at, leaf) -> boxes[at] <= x && x <= boxes[at + 3], found::set);
    for (ShapeInstance shape : tree.shapes()) {
      double[] box = shape.bounds();
      if (box[0] <= x && x <= box[3]) {
        assertThat(found.get(shape.index())).isTrue();
      }
    }
    double farthest =
        tree.shapes().stream()
            .filter(ShapeInstance::shown)
            .mapToDouble(shape -> Math.hypot(Math.max(x, shape.bounds()[3] - x), 0.5))
            .max()
            .orElse(0);
    assertThat(DepthRange.of(tree, new Vector3d(x, 0, 0), 0, 0).far()).isGreaterThan(farthest);
  }

  private void edit(Random random) {
    int at = random.nextInt(groups.size());
    Node group = groups.get(at);
    switch (random.nextInt(6)) {
      case 0, 1 -> nodes.send(group, "addChildren", List.of(child(at, random)));
      case 2 -> nodes.send(group, "removeChildren", List.of(child(at, random)));
      case 3 -> nodes.send(group, "visible", random.nextInt(3) > 0);
      case 4 -> {
        Node shape = shapes.get(random.nextInt(shapes.size()));
        float[] size = {1 + random.nextInt(50), 1, 1};
        nodes.send(shape, "geometry", nodes.node("Box", "size", size));
      }
      default -> {
        if (group.type().name().equals("Switch")) {
          nodes.send(group, "whichChoice", random.nextInt(4) - 1);
        } else if (group.type().name().equals("Transform")) {
          nodes.send(group, "translation", new float[] {random.nextInt(9), 0, 0});
        }
      }
    }
  }

  /** A shape or a group further down, so that no group contains itself. */
  private Node child(int above, Random random) {
    int below = groups.size() - above - 1;
    return below > 0 && random.nextBoolean()
        ? groups.get(above + 1 + random.nextInt(below))
        : shapes.get(random.nextInt(shapes.size()));
  }

  private static void compare(InstanceTree kept, InstanceTree fresh) {
    assertThat(kept.shownPolygons()).isEqualTo(fresh.shownPolygons());
    assertThat(kept.shapes()).hasSameSizeAs(fresh.shapes());
    for (int i = 0; i < fresh.shapes().size(); i++) {
      ShapeInstance one = kept.shapes().get(i);
      ShapeInstance other = fresh.shapes().get(i);
      assertThat(one.node()).isSameAs(other.node());
      assertThat(one.shown()).isEqualTo(other.shown());
      assertThat(one.world()).isEqualTo(other.world());
      assertThat(one.bounds()).isEqualTo(other.bounds());
      assertThat(one.mesh()).isEqualTo(other.mesh());
    }
  }
}
