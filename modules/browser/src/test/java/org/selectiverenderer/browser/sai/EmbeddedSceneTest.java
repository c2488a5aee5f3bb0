package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.nodes.keyboard.KeyboardEvent;
import org.selectiverenderer.browser.scene.Node;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.ImportedNodeException;
import org.web3d.x3d.sai.InvalidExecutionContextException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidProtoException;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.SFFloat;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DRoute;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.core.MetadataSet;
import org.web3d.x3d.sai.core.MetadataString;
import org.web3d.x3d.sai.grouping.Switch;
import org.web3d.x3d.sai.grouping.Transform;
import org.web3d.x3d.sai.interpolation.PositionInterpolator;

/** Scenes made, changed and shown. */
class EmbeddedSceneTest {
  private static final String GOOD = SaiFixture.file("<Switch DEF='S' whichChoice='2'/>");

  private @TempDir Path dir;
  private final SaiFixture sai = new SaiFixture();
  private final ExternalBrowser browser = sai.browser;

  @AfterEach
  void close() {
    sai.close();
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(dir.resolve(name), text);
  }

  @Test
  void aSceneWithoutNamesHasNoneThatIsNull() {
    X3DScene scene = browser.createScene(browser.getProfile("Immersive"), null);
    assertThatThrownBy(() -> scene.getNamedNode(null)).isInstanceOf(InvalidNodeException.class);
    assertThatThrownBy(() -> scene.getImportedNode(null)).isInstanceOf(InvalidNodeException.class);
    assertThatCode(
            () -> {
              scene.removeMetaData(null);
              scene.removeExportedNode(null);
              scene.removeImportedNode(null);
              scene.removeNamedNode(null);
            })
        .doesNotThrowAnyException();
  }

  @Test
  void aSceneBuiltFromNothingBehaves() {
    X3DScene scene = browser.createScene(browser.getProfile("Immersive"), null);
    X3DNode clock = scene.createNode("TimeSensor");
    ((org.web3d.x3d.sai.time.TimeSensor) clock).setCycleInterval(4);
    ((org.web3d.x3d.sai.time.TimeSensor) clock).setLoop(true);
    PositionInterpolator path = (PositionInterpolator) scene.createNode("PositionInterpolator");
    path.setKey(new float[] {0, 1});
    path.setKeyValue(new float[] {0, 0, 0, 8, 0, 0});
    Transform moved = (Transform) scene.createNode("Transform");
    moved.setChildren(new X3DNode[] {scene.createNode("Shape")});
    for (X3DNode node : List.of(clock, path, moved)) {
      scene.addRootNode(node);
    }
    scene.updateNamedNode("Moved", moved);
    scene.addRoute(clock, "fraction_changed", path, "set_fraction");
    scene.addRoute(path, "value_changed", moved, "translation");
    scene.addMetaData("title", "made");
    assertThat(scene.getEncoding()).isEqualTo(X3DExecutionContext.SCRIPTED_ENCODING);
    assertThat(scene.getMetaData()).containsEntry("title", "made");
    assertThat(scene.getRoutes()).hasSize(2);
    browser.replaceWorld(scene);
    sai.step();
    sai.step();
    sai.step();

    float[] at = new float[3];
    sai.node("Moved", Transform.class).getTranslation(at);
    assertThat(at[0]).isGreaterThan(0).isLessThan(8);
    scene.removeRootNode(moved);
    assertThat(scene.getRootNodes()).containsExactly(clock, path);
    scene.removeMetaData("title");
    assertThat(scene.getMetaData()).isEmpty();
  }

  @Test
  void componentsThatAreNotThereAreRefused() {
    ComponentInfo component = browser.getComponentInfo("Grouping", 2);
    assertThat(
            browser
                .createScene(browser.getProfile("Core"), new ComponentInfo[] {component})
                .getComponents())
        .extracting(ComponentInfo::getName)
        .containsExactly("Grouping");
    assertThatThrownBy(() -> browser.getComponentInfo("Grouping", 99))
        .isInstanceOf(NotSupportedException.class);
    assertThatThrownBy(() -> browser.getComponentInfo("Nothing", 1))
        .isInstanceOf(NotSupportedException.class);
    assertThatThrownBy(() -> browser.getProfile("Nothing"))
        .isInstanceOf(NotSupportedException.class);
    assertThat(browser.getSupportedProfiles()).hasSize(8);
    assertThat(browser.getSupportedComponents())
        .extracting(ComponentInfo::getName)
        .contains("Core", "Navigation")
        .isSorted();
  }

  @Test
  void namesAreGivenMovedAndTakenAway() {
    X3DScene scene = browser.createX3DFromString(GOOD);
    X3DNode other = scene.createNode("Group");
    scene.updateNamedNode("S", other);
    assertThat(scene.getNamedNode("S")).isSameAs(other);
    scene.removeNamedNode("S");
    assertThatThrownBy(() -> scene.getNamedNode("S"))
        .isInstanceOf(InvalidNodeException.class)
        .hasMessage("no node has the DEF name S");
    assertThatThrownBy(() -> scene.createNode("Nothing")).isInstanceOf(InvalidNodeException.class);
    assertThatThrownBy(() -> scene.updateExportedNode("S", null))
        .isInstanceOf(InvalidNodeException.class);
    assertThatThrownBy(() -> scene.getExportedNode("S")).isInstanceOf(InvalidNodeException.class);
    assertThatThrownBy(() -> scene.getImportedNode("S")).isInstanceOf(InvalidNodeException.class);
  }

  @Test
  void nodesOfInlinesAreImported() throws IOException {
    write("inner.x3d", SaiFixture.file("<Group DEF='G'/><EXPORT localDEF='G' AS='Out'/>"));
    Path outer =
        write(
            "outer.x3d",
            SaiFixture.file(
                "<Inline DEF='I' url='\"inner.x3d\"'/>"
                    + "<IMPORT inlineDEF='I' importedDEF='Out' AS='In'/>"));
    X3DScene scene = browser.createX3DFromURL(new String[] {outer.toString()});
    assertThat(scene.getImportedNode("In").getNodeName()).isEqualTo("Group");
    assertThat(scene.getNamedNode("In")).isSameAs(scene.getImportedNode("In"));
    scene.updateImportedNode("Out", "Again", scene.getNamedNode("I"));
    assertThat(scene.getImportedNode("Again")).isSameAs(scene.getImportedNode("In"));
    assertThatThrownBy(() -> scene.updateNamedNode("In", scene.getNamedNode("I")))
        .isInstanceOf(ImportedNodeException.class);
    assertThatThrownBy(() -> scene.updateImportedNode("No", "X", scene.getNamedNode("I")))
        .isInstanceOf(ImportedNodeException.class);
    scene.removeImportedNode("In");
    assertThatThrownBy(() -> scene.getImportedNode("In")).isInstanceOf(InvalidNodeException.class);
  }

  @Test
  void routesAreAddedOnceAndRemoved() {
    X3DScene scene = browser.createX3DFromString(GOOD);
    X3DNode from = scene.createNode("ScalarInterpolator");
    X3DNode to = scene.createNode("Material");
    X3DRoute route = scene.addRoute(from, "value_changed", to, "transparency");
    assertThat(scene.addRoute(from, "value_changed", to, "set_transparency")).isEqualTo(route);
    assertThat(scene.getRoutes()).containsExactly(route);
    assertThat(route.getSourceNode()).isSameAs(from);
    assertThat(route.getSourceField()).isEqualTo("value_changed");
    assertThat(route.getDestinationNode()).isSameAs(to);
    assertThat(route.getDestinationField()).isEqualTo("transparency");
    assertThatThrownBy(() -> scene.addRoute(from, "nothing", to, "transparency"))
        .isInstanceOf(InvalidReadableFieldException.class);
    assertThatThrownBy(() -> scene.addRoute(from, "value_changed", to, "nothing"))
        .isInstanceOf(InvalidWritableFieldException.class);
    assertThatThrownBy(() -> scene.addRoute(from, "value_changed", to, "diffuseColor"))
        .isInstanceOf(InvalidWritableFieldException.class)
        .hasMessageContaining("the types SFFloat and SFColor differ");
    ((SFFloat) from.getField("set_fraction")).setValue(0.5f);
    scene.removeRoute(route);
    scene.removeRoute(route);
    assertThat(scene.getRoutes()).isEmpty();
  }

  @Test
  void metadataIsReadThroughNodesOfNodes() {
    browser.replaceWorld(
        browser.createX3DFromString(
            SaiFixture.file(
                "<Switch DEF='S'><MetadataSet name='schemas'>"
                    + "<MetadataString name='schemaBelonginess' containerField='value'"
                    + " value='\"A\" \"B\"'/></MetadataSet></Switch><Group DEF='G'/>")));
    X3DMetadataObject metadata = sai.node("S").getMetadata();
    assertThat(metadata.getName()).isEqualTo("schemas");
    MetadataSet set = (MetadataSet) metadata;
    X3DNode[] members = new X3DNode[set.getNumValue()];
    set.getValue(members);
    MetadataString string = (MetadataString) members[0];
    String[] values = new String[string.getNumValue()];
    string.getValue(values);
    assertThat(values).containsExactly("A", "B");
    assertThat(sai.node("G").getMetadata()).isNull();
    sai.node("G").setMetadata(metadata);
    assertThat(sai.node("G").getMetadata()).isSameAs(metadata);
    sai.node("G").setMetadata(null);
    assertThat(sai.node("G").getMetadata()).isNull();
    X3DMetadataObject foreign =
        new X3DMetadataObject() {
          @Override
          public String getName() {
            return "";
          }

          @Override
          public void setName(String value) {}

          @Override
          public String getReference() {
            return "";
          }

          @Override
          public void setReference(String value) {}
        };
    assertThatThrownBy(() -> sai.node("G").setMetadata(foreign))
        .isInstanceOf(InvalidNodeException.class);
  }

  @Test
  void aNodeThatHoldsItselfDoesNotDisturb() {
    browser.replaceWorld(browser.createX3DFromString(SaiFixture.file("<Transform DEF='T'/>")));
    Transform node = sai.node("T", Transform.class);
    node.addChildren(new X3DNode[] {node});
    sai.step();
    assertThat(node.getNumChildren()).isEqualTo(1);
  }

  @Test
  void thereAreNoPrototypes() {
    X3DScene scene = sai.scene();
    assertThat(scene.getProtosNames()).isEmpty();
    assertThat(scene.getExternProtoNames()).isEmpty();
    assertThatThrownBy(() -> scene.createProto("P")).isInstanceOf(InvalidProtoException.class);
    assertThatThrownBy(() -> scene.getProtoDeclaration("P"))
        .isInstanceOf(InvalidProtoException.class);
  }

  @Test
  void aSceneThatIsDisposedOfIsRefused() {
    X3DScene scene = browser.createX3DFromString(GOOD);
    scene.dispose();
    assertThatThrownBy(scene::getRootNodes).isInstanceOf(InvalidExecutionContextException.class);
    assertThatThrownBy(() -> browser.replaceWorld(scene))
        .isInstanceOf(InvalidExecutionContextException.class);
  }

  @Test
  void aListenerMayReplaceTheWorld() {
    browser.replaceWorld(browser.createX3DFromString(GOOD));
    X3DScene next = browser.createX3DFromString(SaiFixture.file("<Group DEF='Next'/>"));
    sai.node("S").getField("whichChoice").addX3DEventListener(event -> browser.replaceWorld(next));
    sai.node("S", Switch.class).setWhichChoice(0);
    sai.step();
    sai.step();
    assertThat(sai.scene().getNamedNodes()).containsExactly("Next");
    assertThat(sai.complaints()).isEmpty();
  }

  /** The frame in which it goes shows a KeySensor, which is not to listen any more. */
  @Test
  void aWorldThatAListenerReplacesHasNoPartInTheRestOfTheFrame() {
    browser.replaceWorld(
        browser.createX3DFromString(
            SaiFixture.file("<Switch DEF='S' whichChoice='-1'><KeySensor/></Switch>")));
    sai.step();
    X3DScene next =
        browser.createX3DFromString(
            SaiFixture.file("<Viewpoint DEF='V' position='1 2 3'/><Group DEF='Next'/>"));
    sai.node("S").getField("whichChoice").addX3DEventListener(event -> browser.replaceWorld(next));
    sai.node("S", Switch.class).setWhichChoice(0);
    sai.step();
    assertThat(sai.world.keys().takes(KeyboardEvent.Action.HOME)).isFalse();
    assertThat(sai.world.bindables().bound("Viewpoint").map(Node::name)).contains("V");
    assertThat(sai.complaints()).isEmpty();
  }
}
