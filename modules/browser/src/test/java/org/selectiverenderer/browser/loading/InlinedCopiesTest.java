package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

/**
 * The scenes of Inlines of the same file share what is alike, and none of them is affected by a
 * change of another.
 */
class InlinedCopiesTest extends RunningSceneLoaderTestCase {
  private static final String COPY = "<Inline url='\"copy.x3d\"'/>";
  private static final float[] RED = {1, 0, 0};

  @BeforeEach
  void threeCopies() throws Exception {
    write(
        "copy.x3d",
        """
        <Shape DEF='S'>
          <Appearance DEF='A'><Material DEF='M' diffuseColor='0 1 0'/></Appearance>
          <IndexedFaceSet DEF='F' coordIndex='0 1 2'>
            <Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/>
          </IndexedFaceSet>
        </Shape>
        <BooleanTrigger DEF='T'/>
        <EXPORT localDEF='T' AS='Out'/>
        """);
    load(COPY.repeat(3));
  }

  private Scene copy(int number) {
    InlineNode inline = (InlineNode) loaded.scene().root().nodes("children").get(number);
    return inline.content().orElseThrow();
  }

  private Node node(int copy, String name) {
    return copy(copy).find(name).orElseThrow();
  }

  private ShapeInstance shape(int copy) {
    return tree.shapes().get(copy);
  }

  private void send(int copy, String name, String field, Object value) {
    Node node = node(copy, name);
    cascade.send(node, node.type().indexOf(field), value);
    tree.update();
  }

  @Test
  void unchangedCopiesHaveTheSameMeshAndMaterial() {
    assertThat(tree.shapes()).hasSize(3);
    for (int i = 1; i < 3; i++) {
      assertThat(shape(i).mesh()).containsSame(shape(0).mesh().orElseThrow());
      assertThat(shape(i).surface()).isSameAs(shape(0).surface());
      assertThat(node(i, "S").template()).isNotNull().isSameAs(node(0, "S").template());
    }
    assertThat(shape(0).surface().diffuse()).containsExactly(0, 1, 0);
  }

  @Test
  void aMaterialThatChangesIsThatOfItsCopyOnly() {
    send(1, "M", "diffuseColor", RED);
    assertThat(shape(1).surface().diffuse()).containsExactly(1, 0, 0);
    assertThat(shape(0).surface().diffuse()).containsExactly(0, 1, 0);
    assertThat(node(0, "M").floats("diffuseColor")).containsExactly(0, 1, 0);
    assertThat(node(1, "M").floats("diffuseColor")).containsExactly(1, 0, 0);
    assertThat(node(2, "M").floats("diffuseColor")).containsExactly(0, 1, 0);
  }

  @Test
  void pointsThatChangeReshapeTheirCopyOnly() {
    send(1, "C", "point", new float[] {0, 0, 0, 3, 0, 0, 0, 3, 0});
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(0).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    assertThat(shape(2).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
  }

  @Test
  void pointsThatChangedWhileNobodyWatchedAreSeenByTheNextTree() {
    tree.close();
    send(1, "C", "point", new float[] {0, 0, 0, 3, 0, 0, 0, 3, 0});
    send(2, "M", "diffuseColor", RED);
    open();
    assertThat(shape(0).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    assertThat(shape(1).bounds()).containsExactly(0, 0, 0, 3, 3, 0);
    assertThat(shape(2).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    assertThat(shape(1).surface().diffuse()).containsExactly(0, 1, 0);
    assertThat(shape(2).surface().diffuse()).containsExactly(1, 0, 0);
  }

  @Test
  void aGeometryThatIsReplacedIsThatOfItsCopyOnly() {
    Node box = loader.factory().make(loader.catalogue().get("Box"), null, node(0, "S").location());
    send(2, "S", "geometry", box);
    assertThat(shape(2).bounds()).containsExactly(-1, -1, -1, 1, 1, 1);
    assertThat(shape(0).bounds()).containsExactly(0, 0, 0, 1, 1, 0);
    assertThat(node(2, "S").location()).isEqualTo(node(0, "S").location());
    assertThat(node(2, "S").template()).isNull();
  }

  @Test
  void namesExportsAndMetaStatementsOfACopyAreItsOwn() {
    Scene first = copy(0);
    first.putExport("More", "M");
    first.putMeta("title", "first");
    first.unname("A");
    assertThat(first.exports()).containsKeys("Out", "More");
    assertThat(copy(1).exports()).containsOnlyKeys("Out");
    assertThat(copy(1).meta()).isEmpty();
    assertThat(first.find("A")).isEmpty();
    assertThat(first.named().keySet()).containsExactly("S", "M", "F", "C", "T");
    assertThat(List.copyOf(copy(1).named().keySet())).containsExactly("S", "A", "M", "F", "C", "T");
    Node material = node(2, "M");
    copy(2).name("S", material);
    assertThat(copy(2).find("S")).containsSame(material);
    assertThat(material.name()).isEqualTo("S");
    assertThat(copy(1).named()).containsEntry("M", node(1, "M")).hasSize(6);
    assertThat(node(1, "S").type().name()).isEqualTo("Shape");
  }
}
