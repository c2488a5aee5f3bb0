package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

class InstanceTreeTest {
  private static final Vector3d UP = new Vector3d(0, 1, 0);
  private final TestNodes nodes = new TestNodes();
  private final CountingAssetProvider assets = new CountingAssetProvider();

  private InstanceTree tree(Node root) {
    return new InstanceTree((GroupingNode) root, assets);
  }

  private Node shape(int polygons) {
    return nodes.node("Shape", "geometry", nodes.node("Box", "size", new float[] {polygons, 1, 1}));
  }

  private Node choice(int which, Node... children) {
    return nodes.node("Switch", "whichChoice", which, "children", List.of(children));
  }

  private static List<Boolean> shown(InstanceTree tree) {
    return tree.shapes().stream().map(Instance::shown).toList();
  }

  @Test
  void switchingShowsTheOtherChildAndMakesNothingAnew() {
    Node node = choice(0, shape(100), shape(7), nodes.group(shape(1), shape(2)));
    InstanceTree tree = tree(nodes.group(shape(1000), node));
    List<ShapeInstance> before = tree.shapes();
    int meshes = assets.meshes;
    assertThat(tree.shownPolygons()).isEqualTo(1100);
    nodes.send(node, "whichChoice", 2);
    assertThat(tree.shownPolygons()).isEqualTo(1100);
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(1003);
    nodes.send(node, "whichChoice", -1);
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(1000);
    nodes.send(node, "whichChoice", 99);
    tree.update();
    assertThat(shown(tree)).containsExactly(true, false, false, false, false);
    assertThat(tree.shapes()).isSameAs(before);
    assertThat(assets.meshes).isEqualTo(meshes);
  }

  @Test
  void aNodeInTwoPlacesHasTwoInstancesThatFollowIt() {
    Node shared = shape(10);
    Node left = nodes.transform(-1, 0, 0, shared);
    Node right = choice(-1, nodes.transform(1, 0, 0, shared));
    InstanceTree tree = tree(nodes.group(left, right));
    assertThat(assets.made).isEqualTo(1);
    assertThat(shown(tree)).containsExactly(true, false);
    assertThat(tree.places(shared))
        .containsExactly(new Matrix4d().translation(-1, 0, 0), new Matrix4d().translation(1, 0, 0));
    nodes.send(right, "whichChoice", 0);
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(20);
  }

  @Test
  void aTransformMovesWhatIsBelowIt() {
    Node inner = shape(1);
    Node sensor = nodes.node("ProximitySensor");
    Node low = nodes.transform(0, 2, 0, inner, sensor);
    Node top = nodes.transform(1, 0, 0, low);
    InstanceTree tree = tree(nodes.group(top, shape(1)));
    assertThat(tree.shapes().get(0).bounds()).startsWith(1, 2, 0);
    nodes.send(top, "translation", new float[] {5, 0, 0});
    tree.update();
    assertThat(tree.shapes().get(0).bounds()).startsWith(5, 2, 0);
    assertThat(tree.shapes().get(1).bounds()).startsWith(0, 0, 0);
    assertThat(tree.places(sensor)).containsExactly(new Matrix4d().translation(5, 2, 0));
  }

  @Test
  void addingAChildKeepsTheInstancesOfTheOthers() {
    Node group = nodes.group(shape(1), shape(2));
    InstanceTree tree = tree(nodes.group(group));
    List<ShapeInstance> before = tree.shapes();
    long version = tree.structureVersion();
    int meshes = assets.meshes;
    nodes.send(group, "addChildren", List.of(shape(4)));
    tree.update();
    assertThat(tree.shapes()).startsWith(before.toArray(new ShapeInstance[0])).hasSize(3);
    assertThat(tree.structureVersion()).isGreaterThan(version);
    assertThat(tree.shownPolygons()).isEqualTo(7);
    assertThat(assets.meshes).isEqualTo(meshes + 1);
    nodes.send(group, "removeChildren", List.of(before.get(0).node()));
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(6);
    assertThat(tree.shapes()).extracting(Instance::node).doesNotContain(before.get(0).node());
  }

  @Test
  void childrenInAnotherOrderComeInThatOrder() {
    Node a = shape(1);
    Node b = shape(2);
    Node node = choice(0, a, b);
    InstanceTree tree = tree(nodes.group(node));
    nodes.send(node, "children", List.of(b, a));
    tree.update();
    assertThat(tree.shapes()).extracting(Instance::node).containsExactly(b, a);
    assertThat(tree.shownPolygons()).isEqualTo(2);
  }

  @Test
  void whatLeftTheSceneBeforeTheUpdateLeavesNothingBehind() {
    Node sensor = nodes.node("ProximitySensor");
    Node inner = nodes.group(shape(1));
    Node outer = nodes.group(inner);
    InstanceTree tree = tree(nodes.group(outer));
    nodes.send(outer, "removeChildren", List.of(inner));
    nodes.send(inner, "addChildren", List.of(shape(5), sensor));
    int meshes = assets.meshes;
    tree.update();
    assertThat(assets.meshes).isEqualTo(meshes);
    assertThat(tree.shapes()).isEmpty();
    assertThat(tree.instances(sensor)).isEmpty();
    assertThat(tree.otherNodes()).isEmpty();
    assertThat(tree.shownPolygons()).isZero();
    nodes.send(outer, "addChildren", List.of(inner));
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(6);
    assertThat(tree.places(sensor)).hasSize(1);
  }

  @Test
  void aShapeThatChangesAndLeavesInTheSameUpdateIsReadAnewWhenItReturns() {
    Node coord = nodes.node("Coordinate", "point", new float[] {5, 1, 1});
    Node leaving = nodes.node("Shape", "geometry", nodes.node("IndexedFaceSet", "coord", coord));
    Node outer = nodes.group(leaving);
    InstanceTree tree = tree(nodes.group(outer));
    int meshes = assets.meshes;
    nodes.send(coord, "point", new float[] {3, 1, 1});
    nodes.send(outer, "removeChildren", List.of(leaving));
    tree.update();
    assertThat(assets.meshes).isEqualTo(meshes);
    nodes.send(outer, "addChildren", List.of(leaving));
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(3);
    nodes.send(leaving, "visible", false);
    tree.update();
    assertThat(tree.shownPolygons()).isZero();
  }

  @Test
  void anotherGeometryChangesTheCountInEveryPlaceShown() {
    Node shared = shape(10);
    InstanceTree tree = tree(nodes.group(shared, choice(-1, shared), nodes.group(shared)));
    assertThat(tree.shownPolygons()).isEqualTo(20);
    nodes.send(shared, "geometry", nodes.node("Box", "size", new float[] {3, 1, 1}));
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(6);
  }

  @Test
  void coordinatesThatChangeGiveEveryShapeThatSharesThemOneNewMesh() {
    Node coord = nodes.node("Coordinate", "point", new float[] {5, 1, 1});
    Node geometry = nodes.node("IndexedFaceSet", "coord", coord);
    Node one = nodes.node("Shape", "geometry", geometry);
    Node other = nodes.node("Shape", "geometry", geometry);
    InstanceTree tree = tree(nodes.group(one, other));
    nodes.send(coord, "point", new float[] {2, 1, 1});
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(4);
    assertThat(assets.made).isEqualTo(2);
  }

  @Test
  void visibleHidesAGroupOrAShape() {
    Node inner = shape(1);
    Node group = nodes.group(inner, shape(2));
    InstanceTree tree = tree(nodes.group(group));
    nodes.send(group, "visible", false);
    tree.update();
    assertThat(tree.shownPolygons()).isZero();
    nodes.send(inner, "visible", false);
    nodes.send(group, "visible", true);
    tree.update();
    assertThat(tree.shownPolygons()).isEqualTo(2);
  }

  @Test
  void aLocalLightReachesItsGroupAndAGlobalOneEverything() {
    Node local = nodes.node("PointLight", "global", false);
    Node global = nodes.node("SpotLight", "global", true);
    InstanceTree tree =
        tree(nodes.group(nodes.group(local, nodes.group(shape(1))), nodes.group(global), shape(1)));
    LightInstance first = tree.lights().get(0);
    LightInstance second = tree.lights().get(1);
    assertThat(tree.shapes().get(0).lights()).containsExactly(first, second);
    assertThat(tree.shapes().get(1).lights()).containsExactly(second);
    nodes.send(local, "global", true);
    tree.update();
    assertThat(tree.shapes().get(1).lights()).containsExactly(first, second);
  }

  @Test
  void shapesUnderTheSameLightsShareOneListInDocumentOrder() {
    Node inner = nodes.node("PointLight", "global", false);
    Node outer = nodes.node("PointLight", "global", false);
    InstanceTree tree =
        tree(
            nodes.group(
                nodes.group(shape(1), inner, nodes.group(shape(1))),
                nodes.node("SpotLight", "global", true),
                outer,
                nodes.group(shape(1))));
    List<LightInstance> all = tree.lights();
    List<ShapeInstance> shapes = tree.shapes();
    assertThat(shapes.get(0).lights()).isEqualTo(all).isSameAs(shapes.get(1).lights());
    assertThat(shapes.get(2).lights()).containsExactly(all.get(1), all.get(2));
  }

  @Test
  void aLightInABranchThatIsNotShownIsOff() {
    Node node = choice(-1, nodes.group(nodes.node("PointLight")));
    InstanceTree tree = tree(nodes.group(node));
    assertThat(tree.lights().get(0).on()).isFalse();
    nodes.send(node, "whichChoice", 0);
    tree.update();
    assertThat(tree.lights().get(0).on()).isTrue();
  }

  @Test
  void otherNodesComeInDocumentOrderEachOnce() {
    Node[] sensors = new Node[50];
    for (int i = 0; i < sensors.length; i++) {
      sensors[i] = nodes.node("ProximitySensor");
    }
    InstanceTree tree = tree(nodes.group(nodes.group(sensors), nodes.group(sensors[7])));
    assertThat(tree.otherNodes()).containsExactly(sensors);
  }

  @Test
  void anInlineShowsItsContentInItsUnitsAndCanBeRefilled() {
    InlineNode inline = (InlineNode) nodes.watch(nodes.node("Inline"));
    InstanceTree tree = tree(nodes.group(inline));
    assertThat(tree.shapes()).isEmpty();
    Scene content = new Scene(nodes.group(shape(2)), "", "4.0", "Full", Map.of(), 0.01);
    inline.refill(content, 0.01);
    tree.update();
    assertThat(tree.shapes().get(0).world()).isEqualTo(new Matrix4d().scale(0.01));
    assertThat(nodes.sent()).isEmpty();
    nodes.send(inline, "load", false);
    tree.update();
    assertThat(tree.shownPolygons()).isZero();
  }

  @Test
  void aLodInTwoPlacesFollowsTheFirstAndSendsOneEvent() {
    Node lod =
        nodes.watch(
            nodes.node("LOD", "range", new float[] {50}, "children", List.of(shape(100), shape(1))),
            "level_changed");
    InstanceTree tree = tree(nodes.group(lod, nodes.transform(100, 0, 0, lod)));
    tree.view(new Vector3d(0, 0, 10), UP, nodes.cascade);
    tree.update();
    assertThat(nodes.sent()).isEmpty();
    for (int i = 0; i < 3; i++) {
      tree.view(new Vector3d(100, 0, 0), UP, nodes.cascade);
      tree.update();
    }
    assertThat(nodes.sent()).containsExactly("level_changed=1");
    assertThat(shown(tree)).containsExactly(false, true, false, true);
  }

  @Test
  void aBillboardTurnsItsChildrenAndIgnoresAFlatPlace() {
    Node shape = shape(1);
    Node flat = nodes.node("Billboard", "children", List.of(shape(1)));
    InstanceTree tree =
        tree(
            nodes.group(
                nodes.node("Billboard", "children", List.of(shape)),
                nodes.node("Transform", "scale", new float[3], "children", List.of(flat))));
    tree.view(new Vector3d(9, 0, 0), UP, nodes.cascade);
    tree.update();
    assertThat(tree.shapes().get(0).world().equals(new Matrix4d().rotationY(Math.PI / 2), 1e-9))
        .isTrue();
    assertThat(tree.shapes().get(1).world().isFinite()).isTrue();
  }

  @Test
  void aSceneThatContainsItselfIsCutOff() {
    Node group = nodes.node("Group");
    group.init(group.type().indexOf("children"), List.of(shape(1), group, group));
    InstanceTree tree = tree(group);
    assertThat(tree.shownPolygons()).isEqualTo(1);
    assertThat(tree.cutOff()).isTrue();
    assertThat(tree(nodes.group(shape(1))).cutOff()).isFalse();
  }

  @Test
  void theBackdropLeavesOutWhatHasNoPartner() {
    BackgroundReader reader = new BackgroundReader(assets);
    Background backdrop =
        reader.read(
            nodes.node(
                "Background",
                "skyColor",
                new float[] {1, 0, 0, 0, 1, 0},
                "skyAngle",
                new float[] {1, 2, 3},
                "groundColor",
                new float[] {0, 0, 1, 1, 1, 1}),
            new Matrix4d());
    assertThat(backdrop.skyColor()).hasSize(6);
    assertThat(backdrop.skyAngle()).containsExactly(1);
    assertThat(backdrop.groundColor()).containsExactly(0, 0, 1);
    assertThat(backdrop.groundAngle()).isEmpty();
    assertThat(
            reader.read(nodes.node("TextureBackground", "skyColor", new float[0]), new Matrix4d()))
        .extracting(Background::plain)
        .isEqualTo(true);
  }

  @Test
  void aLightOfNegativeRadiusReachesEverything() {
    InstanceTree tree =
        tree(
            nodes.group(
                nodes.node("PointLight", "radius", -1f), nodes.node("SpotLight", "radius", 0f)));

    assertThat(tree.lights().stream().map(light -> light.light().radius()))
        .containsExactly(Float.POSITIVE_INFINITY, 0f);
  }
}
