package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.FieldEdits;
import org.selectiverenderer.authoring.editing.NodeField;
import org.selectiverenderer.authoring.editing.NodeFieldList;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** A running scene that takes over an edit is the same as one that is loaded after it. */
class ScenePatchTest {
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'>
        <head><meta name='title' content='Desk'/></head>
        <Scene>
        <ProtoDeclare name='Lamp'><ProtoBody><Group DEF='Inner'><PointLight intensity='0.5'/></Group>
        </ProtoBody></ProtoDeclare>
        <Script DEF='Code'><field accessType='inputOnly' name='in' type='SFBool'/>
          <![CDATA[ecmascript: function in_(v) { }]]></Script>
        <ProximitySensor DEF='Desk' size='3 3 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString DEF='Enter' containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='Can' whichChoice='0'>
          <Shape DEF='Low'><Appearance><Material DEF='Paint' diffuseColor='0 1 0'/></Appearance>
            <Box size='1 1 1'/></Shape>
          <Transform DEF='Place' translation='1 0 0'><Inline url='"other.x3d"'/></Transform>
        </Switch>
        <Switch DEF='Cup' whichChoice='0'><Group/></Switch>
        <Shape><Appearance><Material USE='Paint'/></Appearance><Sphere radius='2'/></Shape>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  @BeforeEach
  void other() throws IOException {
    Files.writeString(
        folder.resolve("other.x3d"),
        "<X3D version='4.0' profile='Full'><Scene><Group DEF='Theirs'/></Scene></X3D>");
  }

  private static DocumentSnapshot[] edited(String what, String by) throws IOException {
    SceneDocument document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    DocumentSnapshot before = document.snapshot();
    int at = SCENE.indexOf(what);
    assertThat(at).as(what).isNotNegative();
    document.type(at, at + what.length(), by);
    return new DocumentSnapshot[] {before, document.snapshot()};
  }

  private static Optional<ScenePatch> patch(DocumentSnapshot[] edited) {
    return SceneTextDiff.between(edited[0], edited[1], NodeCatalogue.load());
  }

  private PreviewScene load(DocumentSnapshot snapshot) throws IOException {
    return new PreviewScene(LoadedPreview.of(snapshot, folder, ContentAccessPolicy.none()));
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '|',
      textBlock =
          """
          diffuseColor='0 1 0',               diffuseColor='1 0 0'
          diffuseColor='0 1 0',               transparency='0.5'
          translation='1 0 0',                translation='0 2 0' rotation='0 1 0 1'
          DEF='Can' whichChoice='0',          DEF='Can' whichChoice='1'
          size='3 3 3',                       size='4 4 4' center='1 1 1'
          |"DeskSchema"|,                     |"DeskSchema" "OfficeSchema"|
          <Scene>,                            <Scene><!-- a line -->
          DEF='Enter',                        DEF='Entering'
          DEF='Place',                        DEF='There'
          """)
  void whatMayChangeIsTakenOverAndLeavesTheSceneAsIfItWereLoaded(String what, String by)
      throws IOException {
    DocumentSnapshot[] edited = edited(what, by);
    try (PreviewScene running = load(edited[0]);
        PreviewScene loaded = load(edited[1])) {
      running.asIf(List.of("DeskSchema"));
      assertThat(patched(running, patch(edited).orElseThrow())).isTrue();
      loaded.asIf(List.of("DeskSchema"));
      assertThat(told(running)).isEqualTo(told(loaded));
      assertThat(running.revision()).isEqualTo(edited[1].revision());
    }
  }

  @Test
  void theVersionShownInPlaceStaysWhenAnEditIsTakenOver() throws IOException {
    DocumentSnapshot[] edited = edited("diffuseColor='0 1 0'", "diffuseColor='1 0 0'");
    try (PreviewScene running = load(edited[0])) {
      SwitchNode can = (SwitchNode) running.world().scene().find("Can").orElseThrow();
      running.version(can, 1);
      assertThat(patched(running, patch(edited).orElseThrow())).isTrue();
      assertThat(running.versioned()).contains(can);
      assertThat(can.whichChoice()).isEqualTo(1);
    }
  }

  @Test
  void metadataOfAnObjectThatHadNoneIsKnownToTheSchemas() throws IOException {
    DocumentSnapshot[] edited =
        edited(
            "<Switch DEF='Cup' whichChoice='0'>",
            """
            <Switch DEF='Cup' whichChoice='-1'>
              <MetadataSet containerField='metadata'>
                <MetadataSet containerField='value'>
                  <MetadataString containerField='value' name='schemaBelonginess' value='"DeskSchema"'/>
                </MetadataSet>
              </MetadataSet>
            """);
    try (PreviewScene running = load(edited[0]);
        PreviewScene loaded = load(edited[1])) {
      assertThat(patched(running, patch(edited).orElseThrow())).isTrue();
      for (PreviewScene each : List.of(running, loaded)) {
        each.asIf(List.of("DeskSchema"));
        assertThat(each.world().scene().find("Cup").orElseThrow().integer("whichChoice")).isZero();
      }
      assertThat(told(running)).isEqualTo(told(loaded));
    }
  }

  /** What is clicked on is found in the text as it is now. */
  @Test
  void nodesAreFoundWhereAnEditHasMovedThem() throws IOException {
    DocumentSnapshot[] edited = edited("<Scene>", "<Scene>\n\n\n");
    try (PreviewScene running = load(edited[0]);
        PreviewScene loaded = load(edited[1])) {
      Node box = running.world().scene().find("Low").orElseThrow();
      SourceAnchor there = loaded.nodes().anchor(loaded.world().scene().find("Low").orElseThrow());
      assertThat(patched(running, patch(edited).orElseThrow())).isTrue();
      assertThat(running.nodes().anchor(box)).isEqualTo(there);
      SourceAnchor nameless = new SourceAnchor(Optional.empty(), there.line(), there.column());
      assertThat(running.nodes().find(List.of(nameless))).containsSame(box);
    }
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '|',
      textBlock =
          """
          radius='2',             radius='3'
          <Group/>,               <Group/><Group/>
          DEF='Paint',            DEF='Colour'
          |url='"other.x3d"'|,    |url='"another.x3d"'|
          intensity='0.5',        intensity='0.6'
          function in_,           function in_to
          name='in',              name='into'
          translation='1 0 0',    translation='1 zero 0'
          version='4.0',          version='3.3'
          USE='Paint',            diffuseColor='1 1 1'
          """)
  void whatIsMoreThanAValueMeansLoading(String what, String by) throws IOException {
    assertThat(patch(edited(what, by))).isEmpty();
  }

  @Test
  void aValueOfAPrototypesInstanceIsInTheSceneThatIsLoadedNext() throws IOException {
    String scene =
        """
        <X3D profile='Immersive' version='4.0'><Scene>
          <ProtoDeclare name='Chair'><ProtoInterface>
            <field name='colour' type='SFColor' accessType='inputOutput' value='1 0 0'/>
          </ProtoInterface><ProtoBody><Shape><Appearance><Material>
            <IS><connect nodeField='diffuseColor' protoField='colour'/></IS>
          </Material></Appearance><Box/></Shape></ProtoBody></ProtoDeclare>
          <ProtoInstance name='Chair' DEF='Chair1'/>
        </Scene></X3D>
        """;
    SceneDocument document = SceneDocument.of("scene.x3d", scene.getBytes(StandardCharsets.UTF_8));
    DocumentSnapshot before = document.snapshot();
    DocumentElement chair = document.tree().orElseThrow().named("Chair1").orElseThrow();
    NodeField colour =
        NodeFieldList.of(document, NodeCatalogue.load(), chair).stream()
            .filter(field -> field.name().equals("colour"))
            .findFirst()
            .orElseThrow();
    document.perform(new FieldEdits(document).set(chair, colour, "0 0 1"));
    DocumentSnapshot after = document.snapshot();
    assertThat(patch(new DocumentSnapshot[] {before, after})).isEmpty();
    try (PreviewScene old = load(before);
        PreviewScene now = load(after)) {
      assertThat(told(old)).contains("diffuseColor=[[1.0, 0.0, 0.0]]");
      assertThat(told(now)).contains("diffuseColor=[[0.0, 0.0, 1.0]]");
    }
  }

  @Test
  void aStateThatTheSceneDoesNotShowIsRefused() throws IOException {
    DocumentSnapshot[] edited = edited("0 1 0", "1 1 0");
    ScenePatch patch = patch(edited).orElseThrow();
    try (PreviewScene running = load(edited[0])) {
      assertThat(patched(running, patch)).isTrue();
      assertThat(patched(running, patch)).as("for the second time").isFalse();
    }
  }

  /** All fields of all nodes, metadata too. */
  static boolean patched(PreviewScene scene, ScenePatch patch) {
    return scene.patch(patch, AddedNodes.of(patch, scene.loaded()));
  }

  static String told(PreviewScene scene) {
    StringBuilder text =
        new StringBuilder(new TreeSet<>(scene.world().scene().named().keySet()) + "\n");
    for (Node node : NodeSubgraphCollector.of(scene.world().scene().root())) {
      text.append(scene.nodes().anchor(node)).append(fields(node)).append('\n');
    }
    return text.toString();
  }

  private static String fields(Node node) {
    StringBuilder text = new StringBuilder(node.type().name());
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.value(field.index());
      text.append(' ').append(field.name()).append('=');
      if (value instanceof Node other) {
        text.append(field.name().equals("metadata") ? fields(other) : other.type().name());
      } else if (field.type() == FieldType.MFNode) {
        boolean own = node.type().is("X3DMetadataObject");
        node.nodes(field.name())
            .forEach(child -> text.append(own ? fields(child) : child.type().name()));
      } else {
        text.append(Arrays.deepToString(new Object[] {value}));
      }
    }
    return text.toString();
  }
}
