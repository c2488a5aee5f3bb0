package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** A running scene takes over an edit from the part of the text that it is in. */
class ChangedPartTest {
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'>
        <Scene>
        <ProtoDeclare name='Lamp'><ProtoBody><Group><PointLight intensity='0.5'/></Group>
        </ProtoBody></ProtoDeclare>
        <Viewpoint DEF='Start' position='0 0 9'/>
        <Transform DEF='First' translation='1 0 0'>
          <Shape DEF='Box'><Appearance><Material DEF='Paint' diffuseColor='0 1 0'/></Appearance>
            <Box DEF='Form' size='1 1 1'/></Shape>
        </Transform> <Group DEF='Beside'/>
        <ProximitySensor DEF='Area' size='3 3 3'>
          <MetadataSet containerField='metadata' name='Area'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='Can' whichChoice='0'>
          <Shape DEF='Low'><Appearance><Material USE='Paint'/></Appearance>
            <Sphere radius='2'/></Shape>
          <Group DEF='Empty'></Group>
        </Switch>
        <Group><Shape DEF='Round'><Sphere radius='5'/></Shape><Shape><Cone/></Shape></Group>
        <Shape DEF='Last'><IndexedFaceSet coordIndex='0 1 2 -1'>
          <Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  /** A document whose edits are put together. */
  private static final class Edited {
    private final SceneDocument document;
    private final DocumentSnapshot before;
    private final List<ChangedRange> ranges = new ArrayList<>();

    Edited(String scene) throws IOException {
      document = SceneDocument.of("scene.x3d", scene.getBytes(StandardCharsets.UTF_8));
      before = document.snapshot();
      document.addListener(change -> ranges.add(ChangedRange.of(change)));
    }

    Edited replace(String what, String by) {
      int at = document.text().toString().indexOf(what);
      assertThat(at).as(what).isNotNegative();
      int same = 0;
      while (same < Math.min(what.length(), by.length())
          && what.charAt(what.length() - 1 - same) == by.charAt(by.length() - 1 - same)) {
        same++;
      }
      // As edits do, it leaves alone what stays behind it.
      document.type(at, at + what.length() - same, by.substring(0, by.length() - same));
      return this;
    }

    List<ChangedPart> parts() {
      ChangedRange all = ranges.stream().reduce(ChangedRange::and).orElseThrow();
      return ChangedPart.of(document, all, NodeCatalogue.load());
    }

    Optional<ScenePatch> patch() {
      return parts().stream()
          .flatMap(
              part ->
                  SceneTextDiff.between(before, document.snapshot(), part, NodeCatalogue.load())
                      .stream())
          .findFirst();
    }
  }

  private PreviewScene load(DocumentSnapshot snapshot) throws IOException {
    return new PreviewScene(LoadedPreview.of(snapshot, folder, ContentAccessPolicy.none()));
  }

  private void takenOver(Edited edited) throws IOException {
    DocumentSnapshot now = edited.document.snapshot();
    try (PreviewScene running = load(edited.before);
        PreviewScene loaded = load(now)) {
      running.asIf(List.of("DeskSchema"));
      loaded.asIf(List.of("DeskSchema"));
      assertThat(ScenePatchTest.patched(running, edited.patch().orElseThrow())).isTrue();
      assertThat(ScenePatchTest.told(running)).isEqualTo(ScenePatchTest.told(loaded));
      assertThat(running.nodes().all().toString()).isEqualTo(loaded.nodes().all().toString());
      assertThat(running.revision()).isEqualTo(now.revision());
      running.look(running.pose());
      loaded.look(loaded.pose());
      assertThat(running.world().instances().shownPolygons())
          .isEqualTo(loaded.world().instances().shownPolygons());
    }
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '|',
      textBlock =
          """
          translation='1 0 0',          translation='2 0 0'
          translation='1 0 0',          translation='2 0 0' scale='2 2 2'
          diffuseColor='0 1 0',         diffuseColor='1 0 0'
          position='0 0 9',             position='0 2 9'
          DEF='First',                  DEF='Renamed'
          DEF='First',                  |id='x'|
          |"DeskSchema"|,               |"OfficeSchema"|
          size='3 3 3',                 size='4 4 4'
          DEF='Can' whichChoice='0',    DEF='Can' whichChoice='1'
          radius='5',                   radius='6'
          <Cone/>,                      |<Cone bottomRadius='3'/><!-- x -->|
          0 1 2 -1',                    0 2 1 -1'
          <Group DEF='Beside'/>,        <Group DEF='Other'><Shape><Box/></Shape></Group>
          <Group DEF='Beside'/>,        ||
          <Group DEF='Empty'></Group>,  <Group DEF='Empty'><Shape DEF='New'><Box/></Shape></Group>
          <Group DEF='Empty'></Group>,  |<Group DEF='Empty'></Group><Group/>|
          <Group DEF='Empty'></Group>,  <Group/><Group DEF='Empty'></Group>
          <Shape DEF='Last'>,           <Group><Shape/></Group><Shape DEF='Last'>
          </Scene>,                     <ProximitySensor DEF='Extra' size='1 1 1'/></Scene>
          """)
  void anEditIsTakenOverAsIfTheSceneWereLoaded(String what, String by) throws IOException {
    takenOver(new Edited(SCENE).replace(what, by));
  }

  @Test
  void linesThatComeMoveWhatIsBehindThem() throws IOException {
    takenOver(
        new Edited(SCENE).replace("<Group DEF='Beside'/>", "<Group/>\n\n  <Group DEF='Beside'/>"));
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '|',
      textBlock =
          """
          <Group DEF='Mark'/>,            <Group/><Group DEF='Mark'/>
          <Group DEF='Mark'/>,            ||
          <Group DEF='Behind'/>,          <Shape DEF='New'><Box/></Shape><Group DEF='Behind'/>
          |<ProtoInstance name='Lamp'/>|, |<ProtoInstance name='Lamp'/><Group/>|
          """)
  void whatStandsBehindAnInstanceOfAPrototypeIsTakenOver(String what, String by)
      throws IOException {
    takenOver(
        new Edited(
                SCENE.replace(
                    "<Group DEF='Beside'/>",
                    "<ProtoInstance DEF='L' name='Lamp'/><Group DEF='Mark'/>"
                        + "<Transform><ProtoInstance name='Lamp'/><Group DEF='Behind'/>"
                        + "</Transform>"))
            .replace(what, by));
  }

  /** A texture is drawn instead of a colour in X3D 3, and on it in X3D 4 (X3D 4.0, 12.2.4). */
  @ParameterizedTest
  @CsvSource({"3.3", "4.0"})
  void nodesThatComeBackMeanWhatTheyMeantInTheVersionOfTheScene(String version) throws IOException {
    String shape =
        "<Shape DEF='Red'><Appearance><Material diffuseColor='1 0 0'/>"
            + "<PixelTexture image='1 1 3 0xFFFFFF'/></Appearance><Box/></Shape>";
    Edited edited =
        new Edited(
            "<X3D profile='Immersive' version='%s'>\n<Scene><Group DEF='G'/>%s</Scene></X3D>"
                .formatted(version, shape));
    try (PreviewScene running = load(edited.before);
        PreviewScene loaded = load(edited.before)) {
      DocumentSnapshot before = edited.before;
      for (String[] each : new String[][] {{shape, ""}, {"</Scene>", shape + "</Scene>"}}) {
        edited.ranges.clear();
        edited.replace(each[0], each[1]);
        DocumentSnapshot was = before;
        DocumentSnapshot now = edited.document.snapshot();
        assertThat(
                ScenePatchTest.patched(
                    running,
                    edited.parts().stream()
                        .flatMap(
                            p -> SceneTextDiff.between(was, now, p, NodeCatalogue.load()).stream())
                        .findFirst()
                        .orElseThrow()))
            .isTrue();
        before = now;
      }
      assertThat(material(running)).isEqualTo(material(loaded));
    }
  }

  private static String material(PreviewScene scene) {
    return scene.nodes().shapes(scene.world().scene().find("Red").orElseThrow()).stream()
        .map(ShapeInstance::surface)
        .map(surface -> Arrays.toString(surface.diffuse()) + surface.tints())
        .collect(Collectors.joining());
  }

  @Test
  void severalEditsAreTakenOverTogether() throws IOException {
    takenOver(
        new Edited(SCENE)
            .replace("translation='1 0 0'", "translation='1 2 0'")
            .replace("<Group DEF='Beside'/>", "<Group/>")
            .replace("translation='1 2 0'", "translation='1 2 3'"));
  }

  @Test
  void oneEditAfterTheOtherIsTakenOver() throws IOException {
    Edited edited = new Edited(SCENE);
    try (PreviewScene running = load(edited.before)) {
      DocumentSnapshot before = edited.before;
      for (String[] each :
          new String[][] {
            {
              "<Group DEF='Beside'/>", "<Group/>\n<Group DEF='Beside'><Shape><Box/></Shape></Group>"
            },
            {"<Box/>", "<Box size='3 3 3'/>"},
            {"DEF='Beside'", "\nDEF='By'"},
            {"radius='5'", "radius='1'"},
            {"<Group/>", ""}
          }) {
        edited.ranges.clear();
        edited.replace(each[0], each[1]);
        DocumentSnapshot now = edited.document.snapshot();
        DocumentSnapshot was = before;
        Optional<ScenePatch> patch =
            edited.parts().stream()
                .flatMap(p -> SceneTextDiff.between(was, now, p, NodeCatalogue.load()).stream())
                .findFirst();
        assertThat(ScenePatchTest.patched(running, patch.orElseThrow())).as(each[0]).isTrue();
        before = now;
        try (PreviewScene loaded = load(now)) {
          assertThat(ScenePatchTest.told(running))
              .as(each[0])
              .isEqualTo(ScenePatchTest.told(loaded));
        }
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '|',
      textBlock =
          """
          DEF='Paint',                  DEF='Colour'
          size='1 1 1',                 size='2 1 1'
          <Sphere radius='2'/>,         <Sphere radius='3'/>
          DEF='First',                  DEF='Last'
          intensity='0.5',              intensity='0.6'
          version='4.0',                version='3.3'
          </Scene>,                     <Viewpoint/></Scene>
          </Scene>,                     <Shape USE='Box'/></Scene>
          </Scene>,                     <Group DEF='Box'/></Scene>
          </Scene>,                     |<Inline url='"a.x3d"'/></Scene>|
          </Scene>,                     <Script/></Scene>
          </Scene>,                     <Group DEF='P'/><Group DEF='P'/></Scene>
          </Scene>,                     <ProtoInstance name='Lamp'/></Scene>
          """)
  void whatThePartDoesNotTellMeansLoading(String what, String by) throws IOException {
    assertThat(new Edited(SCENE).replace(what, by).patch()).isEmpty();
  }

  /**
   * However large the scene is, an edit compares no more than the object that it is in. In one line
   * a look at the line for each object would take minutes.
   */
  @ParameterizedTest
  @ValueSource(strings = {"\n", " "})
  void ofALargeSceneOneObjectIsRead(String between) throws IOException {
    StringBuilder scene = new StringBuilder("<X3D version='4.0'>\n<Scene>");
    for (int i = 0; i < 30_000; i++) {
      scene.append(between);
      scene.append("<Transform DEF='T").append(i).append("'><Shape><Box/></Shape></Transform>");
    }
    String text = scene.append("</Scene></X3D>").toString();
    for (String[] each :
        new String[][] {
          {"DEF='T29777'", "DEF='Renamed'"},
          {"DEF='T29777'", "DEF='T29777' translation='1 1 1'"},
          {"<Transform DEF='T29777'>", "<Group/><Transform DEF='T29777'>"},
          {"<Transform DEF='T29777'><Shape><Box/></Shape></Transform>", ""}
        }) {
      Edited edited = new Edited(text).replace(each[0], each[1]);
      assertThat(edited.patch()).as(each[1]).isPresent();
      assertThat(edited.parts())
          .as(each[1])
          .allMatch(part -> part.range().to() - part.range().from() < 400);
    }
  }
}
