package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

/**
 * The nodes in a Shape of a file that is inlined again are made when somebody asks for them, and
 * nobody can tell.
 */
class DeferredPartsTest extends RunningSceneLoaderTestCase {
  private static final float[] RED = {1, 0, 0};
  private static final float[] LARGE = {0, 0, 0, 3, 0, 0, 0, 3, 0};

  private static final String SHAPE =
      """
      <Shape DEF='S'>
        <Appearance>
          <Material diffuseColor='0 1 0'/>
          <MetadataSet name='m' containerField='metadata'/>
        </Appearance>
        <IndexedFaceSet coordIndex='0 1 2'>
          <Coordinate point='0 0 0 1 0 0 0 1 0'/>
        </IndexedFaceSet>
      </Shape>
      """;

  @BeforeEach
  void threeCopies() throws Exception {
    loadCopies(SHAPE);
  }

  private void loadCopies(String nodes) throws Exception {
    write("copy.x3d", nodes);
    load("<Inline url='\"copy.x3d\"'/>".repeat(3));
  }

  private Scene copy(int number) {
    InlineNode inline = (InlineNode) loaded.scene().root().nodes("children").get(number);
    return inline.content().orElseThrow();
  }

  private Node shapeNode(int copy) {
    return copy(copy).find("S").orElseThrow();
  }

  private Node points(int copy) {
    return shapeNode(copy).node("geometry").node("coord");
  }

  private Node material(int copy) {
    return shapeNode(copy).node("appearance").node("material");
  }

  private ShapeInstance shape(int copy) {
    return tree.shapes().get(copy);
  }

  private void send(Node node, String field, Object value) {
    cascade.send(node, node.type().indexOf(field), value);
    tree.update();
  }

  @Test
  void partsOfFurtherCopiesAreNotMadeForDrawing() {
    assertThat(shapeNode(0).partsDeferred()).isFalse();
    for (int i = 1; i < 3; i++) {
      assertThat(shapeNode(i).partsDeferred()).isTrue();
      assertThat(shape(i).mesh()).containsSame(shape(0).mesh().orElseThrow());
      assertThat(shape(i).surface()).isSameAs(shape(0).surface());
      assertThat(shape(i).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    }
    assertThat(tree.shownPolygons()).isEqualTo(3);
  }

  @Test
  void partsAreMadeOnceAndAreThoseOfTheFile() {
    Node shape = shapeNode(1);
    Node geometry = shape.node("geometry");
    assertThat(shape.partsDeferred()).isFalse();
    assertThat(shapeNode(2).partsDeferred()).isTrue();
    assertThat(shape.node("geometry")).isSameAs(geometry);
    assertThat(geometry).isNotSameAs(shapeNode(0).node("geometry"));
    assertThat(geometry.location()).isEqualTo(shapeNode(0).node("geometry").location());
    assertThat(geometry.template()).isSameAs(shapeNode(0).node("geometry").template());
    assertThat(points(1).floats("point")).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    assertThat(material(1).floats("diffuseColor")).containsExactly(0, 1, 0);
    assertThat(shape.node("appearance").node("metadata").string("name")).isEqualTo("m");
    assertThat(shape.template()).isSameAs(shapeNode(0).template());
    assertThat(shape.changes()).isZero();
  }

  @Test
  void aPartThatChangesIsThatOfItsCopyOnly() {
    send(material(1), "diffuseColor", RED);
    assertThat(shape(1).surface().diffuse()).containsExactly(1, 0, 0);
    assertThat(shape(0).surface().diffuse()).containsExactly(0, 1, 0);
    assertThat(shape(2).surface().diffuse()).containsExactly(0, 1, 0);
    send(points(1), "point", LARGE);
    send(points(2), "point", LARGE);
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(2).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(0).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    send(points(1), "point", new float[] {0, 0, 0, 2, 0, 0, 0, 2, 0});
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 2, 2, 0);
    assertThat(shape(1).surface().diffuse()).containsExactly(1, 0, 0);
  }

  @Test
  void aPartThatChangedWhileNobodyWatchedIsSeenByTheNextTree() {
    tree.close();
    send(points(1), "point", LARGE);
    open();
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(2).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    send(points(1), "point", new float[] {0, 0, 0, 2, 0, 0, 0, 2, 0});
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 2, 2, 0);
  }

  @Test
  void aFieldOfTheShapeItselfCanChange() {
    Node box = loader.factory().make(loader.catalogue().get("Box"), null, shapeNode(0).location());
    send(shapeNode(2), "geometry", box);
    assertThat(shape(2).bounds()).containsExactly(-1, -1, -1, 1, 1, 1);
    assertThat(shape(2).surface().diffuse()).containsExactly(0, 1, 0);
    assertThat(shapeNode(2).template()).isNull();
    send(material(2), "diffuseColor", RED);
    assertThat(shape(2).surface().diffuse()).containsExactly(1, 0, 0);
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
  }

  @Test
  void theTreeFollowsAfterTheFirstCopyHasChanged() {
    tree.close();
    send(points(0), "point", LARGE);
    open();
    assertThat(shape(0).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    send(material(1), "diffuseColor", RED);
    assertThat(shape(1).surface().diffuse()).containsExactly(1, 0, 0);
    assertThat(shape(2).surface().diffuse()).containsExactly(0, 1, 0);
  }

  @Test
  void partsWithANameAreMadeAtOnce() throws Exception {
    loadCopies(SHAPE.replace("<Material ", "<Material DEF='M' "));
    for (int i = 0; i < 3; i++) {
      assertThat(shapeNode(i).partsDeferred()).isFalse();
      assertThat(copy(i).find("M")).containsSame(material(i));
    }
  }

  @Test
  void partsOfAPrototypeInstanceKeepTheirConnections() throws Exception {
    loadCopies(
        """
        <ProtoDeclare name='P'>
          <ProtoInterface>
            <field name='colour' type='SFColor' accessType='inputOutput' value='0 1 0'/>
          </ProtoInterface>
          <ProtoBody>
            <Shape><Appearance><Material>
              <IS><connect nodeField='diffuseColor' protoField='colour'/></IS>
            </Material></Appearance><Box/></Shape>
          </ProtoBody>
        </ProtoDeclare>
        <ColorInterpolator DEF='C' key='0 1' keyValue='1 0 0 1 0 0'/>
        <ProtoInstance name='P' DEF='I'/>
        <ROUTE fromNode='C' fromField='value_changed' toNode='I' toField='colour'/>
        """);
    Node source = copy(1).find("C").orElseThrow();
    send(source, "set_fraction", 0.5f);
    assertThat(shape(1).surface().diffuse()).containsExactly(1, 0, 0);
    assertThat(shape(2).surface().diffuse()).containsExactly(0, 1, 0);
  }

  @Test
  void severalThreadsGetTheSameParts() throws Exception {
    int threads = 4;
    ExecutorService readers = Executors.newFixedThreadPool(threads);
    try {
      for (int copy = 1; copy < 3; copy++) {
        Node shape = shapeNode(copy);
        CyclicBarrier start = new CyclicBarrier(threads);
        Callable<Node> reading =
            () -> {
              start.await();
              return shape.node("geometry");
            };
        List<Future<Node>> read = readers.invokeAll(List.of(reading, reading, reading, reading));
        for (Future<Node> one : read) {
          assertThat(one.get()).isNotNull().isSameAs(shape.node("geometry"));
        }
      }
    } finally {
      readers.shutdown();
    }
  }
}
