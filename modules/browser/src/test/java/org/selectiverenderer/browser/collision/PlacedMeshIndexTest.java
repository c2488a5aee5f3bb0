package org.selectiverenderer.browser.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TestMeshes;

class PlacedMeshIndexTest {
  private final TestWorld world = new TestWorld();
  private final Mesh cube = TestMeshes.box(-1, -1, -1, 1, 1, 1);
  private final List<GroupingNode> places = new ArrayList<>();

  private void street(int length) {
    for (int i = 0; i < length; i++) {
      places.add(world.moved(5 * i, 0, 0, world.shape(cube)));
    }
    world.add(places.toArray(GroupingNode[]::new));
  }

  private void move(int place, double x, double y) {
    world.set(places.get(place), "translation", new float[] {(float) x, (float) y, 0});
    world.tree();
  }

  private PlacedMeshIndex<PlacedMesh.OfShape> index() {
    InstanceTree tree = world.tree();
    return new PlacedMeshIndex<>(
        tree.shapes().stream().map(shape -> new PlacedMesh.OfShape(shape, List.of())).toList(),
        tree,
        world.bvhs);
  }

  private long looksForOneMove(int length) {
    places.clear();
    world.set(world.root, "children", List.of());
    street(length);
    PlacedMeshIndex<PlacedMesh.OfShape> index = index();
    move(length / 2, 0, 30);
    index.refresh();
    return index.looks();
  }

  @Test
  void oneShapeThatMovesCostsTheSameHoweverManyThereAre() {
    assertThat(looksForOneMove(400)).isEqualTo(looksForOneMove(10)).isPositive();
  }

  @Test
  void whateverMovesIsFoundAsByANewIndex() {
    street(40);
    Random random = new Random(37);
    PlacedMeshIndex<PlacedMesh.OfShape> index = index();
    for (int round = 0; round < 200; round++) {
      for (int i = random.nextInt(4); i > 0; i--) {
        move(random.nextInt(places.size()), random.nextInt(200), random.nextInt(3));
      }
      index.refresh();
      double x = random.nextInt(200) + 0.3;
      assertThat(hit(index, x)).isEqualTo(hit(index(), x));
    }
  }

  private static double hit(PlacedMeshIndex<PlacedMesh.OfShape> index, double x) {
    return index
        .ray(new Vector3d(x, 10, 0.2), new Vector3d(0, -1, 0), 100, false)
        .map(found -> found.at().distance())
        .orElse(-1.0);
  }
}
