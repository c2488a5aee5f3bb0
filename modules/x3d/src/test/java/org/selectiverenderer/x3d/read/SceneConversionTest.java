package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** Scenes written in another encoding are the same scenes, and written back as well. */
class SceneConversionTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final X3dReader READER = new X3dReader(CATALOGUE);

  static final String ALL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!-- of the file -->
      <X3D profile='Immersive' version='3.3'><head>
      <component name='HAnim' level='1'/><unit category='length' name='foot' conversionFactor='0.3048'/>
      <meta name='title' content='a "quoted" &amp; &lt;long&gt; title'/></head><Scene>
      <!-- of the world: a - -b -->
      <WorldInfo title="it's" info='"one" "two \\"three\\" \\\\" "B&#xFC;ro&#10;line"'/>
      <ProtoDeclare name='Ball'><ProtoInterface>
        <field name='radius' type='SFFloat' accessType='inputOutput' value='.50'/>
        <field name='names' type='MFString' accessType='initializeOnly' value='"a" "b"'/>
        <field name='on' type='SFBool' accessType='inputOnly'/>
        <field name='look' type='SFNode' accessType='initializeOnly'><Material DEF='L'/></field>
        <field name='kids' type='MFNode' accessType='inputOutput'/></ProtoInterface>
        <ProtoBody><Group DEF='G'><Group><IS><connect nodeField='children' protoField='kids'/></IS>
        </Group><Shape><Sphere><IS><connect nodeField='radius' protoField='radius'/></IS></Sphere>
        <Appearance><IS><connect nodeField='material' protoField='look'/></IS></Appearance></Shape>
        <TouchSensor DEF='T'><IS><connect nodeField='enabled' protoField='on'/></IS></TouchSensor>
        <WorldInfo><IS><connect nodeField='info' protoField='names'/></IS></WorldInfo></Group>
        </ProtoBody></ProtoDeclare>
      <ProtoDeclare name='Look'><ProtoBody><Appearance><Material/></Appearance></ProtoBody></ProtoDeclare>
      <ProtoInstance name='Ball' DEF='B'><fieldValue name='radius' value='2.0'/>
        <fieldValue name='kids'><Group DEF='K'/><!-- of the kids --><Shape/></fieldValue></ProtoInstance>
      <Collision DEF='C'><Shape DEF='S'><ProtoInstance name='Look' containerField='appearance'/>
        <IndexedFaceSet coordIndex='0 1 2
       -1' solid='false'><Coordinate point='0 0 0, 1.50 0 -2e-3,
        0 +1 .0'/></IndexedFaceSet></Shape><Shape USE='S' containerField='proxy'/>
        <!-- of the collision --></Collision>
      <ProtoInstance USE='B'/>
      <Shape><Appearance><PixelTexture image='2 1 1 0xFF 007'/></Appearance>
        <Text string='"a" ""'><FontStyle justify='"MIDDLE" "END"'/></Text></Shape>
      <Switch whichChoice='-1'><Group/><MetadataSet name='m'><MetadataFloat name='f' value='1 2'/>
        </MetadataSet></Switch>
      <Script DEF='Sc' directOutput='true' url='"other.js"'>
        <field name='in' type='SFFloat' accessType='inputOnly'/>
        <field name='world' type='SFNode' accessType='initializeOnly'><Group USE='K'/></field>
        <field name='list' type='MFVec3f' accessType='initializeOnly' value='1 2 3 4 5 6'/>
        <![CDATA[ecmascript:
      function in_(v) { if (v < 1 && v > 0) print("x\\n"); }
      ]]></Script>
      <TimeSensor DEF='Clock' loop='true' cycleInterval='0.1'/>
      <Transform DEF='Tr' rotation='0 1 0 1.5707963'><Group/><ROUTE fromNode='Clock'
        fromField='fraction_changed' toNode='PI' toField='set_fraction'/></Transform>
      <PositionInterpolator DEF='PI' key='0 1' keyValue='0 0 0 1 1 1'/>
      <ROUTE fromNode='PI' fromField='value_changed' toNode='Tr' toField='translation'/>
      <Inline DEF='In' url='"a.x3d" "b.wrl"' load='false'/>
      <EXPORT localDEF='Tr' AS='Moved'/>
      </Scene></X3D>
      """;

  private static XmlDocument document(String name, byte[] bytes) throws IOException {
    return READER.document(name, new ByteArrayInputStream(bytes), bytes.length);
  }

  private static byte[] converted(byte[] from, SceneFormat format, ProblemCollector problems)
      throws IOException {
    XmlDocument document = document("scene", from);
    assertThat(document.faults()).isEmpty();
    return format.text(document, CATALOGUE, problems).getBytes(StandardCharsets.UTF_8);
  }

  /** Returns what a scene says, without places and without the form of its text. */
  private static List<String> said(byte[] bytes, ProblemCollector problems) {
    X3dFile file = READER.read("scene", bytes, problems);
    List<String> said = new ArrayList<>();
    said.add(file.version() + file.profile() + file.components() + file.meta() + file.units());
    Map<ParsedNode, Integer> seen = new IdentityHashMap<>();
    file.nodes().forEach(node -> say(node, "", seen, said));
    for (X3dFile.ParsedRoute route : file.routes()) {
      said.add(
          seen.get(route.from())
              + "."
              + route.fromField()
              + " "
              + seen.get(route.to())
              + "."
              + route.toField());
    }
    file.imports().forEach(i -> said.add(i.inlineDef() + i.importedDef() + i.as()));
    file.exports().forEach(e -> said.add(e.localDef() + e.as()));
    said.add(file.named().keySet().toString());
    return said;
  }

  private static void say(
      ParsedNode node, String in, Map<ParsedNode, Integer> seen, List<String> said) {
    Integer before = seen.putIfAbsent(node, seen.size());
    said.add(in + node + (before == null ? "" : " again " + before));
    if (before != null) {
      return;
    }
    for (FieldDefinition field : node.type().fields()) {
      if (!node.given(field.index())) {
        continue;
      }
      Object value = node.value(field.index());
      String name = in + "  " + field.name();
      if (value instanceof ParsedNode child) {
        say(child, name + " ", seen, said);
      } else if (value instanceof List<?> children) {
        children.forEach(child -> say((ParsedNode) child, name + " ", seen, said));
      } else {
        said.add(name + " " + Arrays.deepToString(new Object[] {value}));
      }
    }
  }

  private static void assertSame(byte[] scene, SceneFormat format) throws IOException {
    ProblemCollector first = new ProblemCollector();
    List<String> original = said(scene, first);
    byte[] there = converted(scene, format, new ProblemCollector());
    ProblemCollector second = new ProblemCollector();
    // In VRML code is the last of the urls, which the way back shows to be no loss.
    assertThat(withoutCode(said(there, second))).isEqualTo(withoutCode(original));
    assertThat(second.list())
        .extracting(Problem::message)
        .containsExactlyElementsOf(first.list().stream().map(Problem::message).toList());
    byte[] back = converted(there, SceneFormat.XML, new ProblemCollector());
    assertThat(said(back, new ProblemCollector())).isEqualTo(original);
    assertThat(converted(there, SceneFormat.XML, new ProblemCollector())).isEqualTo(back);
  }

  private static List<String> withoutCode(List<String> said) {
    return said.stream().filter(line -> !line.matches("(?s) +(url|sourceCode) \\[.*")).toList();
  }

  @ParameterizedTest
  @EnumSource
  void theSceneStaysTheSame(SceneFormat format) throws IOException {
    assertSame(ALL.getBytes(StandardCharsets.UTF_8), format);
  }

  @ParameterizedTest
  @EnumSource
  void ourScenesStayTheSame(SceneFormat format) throws IOException {
    try (Stream<Path> scenes = Files.list(Path.of("scenes"))) {
      for (Path scene : scenes.filter(file -> file.toString().endsWith(".x3d")).sorted().toList()) {
        if (Files.size(scene) < 300_000) {
          assertSame(Files.readAllBytes(scene), format);
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void commentsAreKept(SceneFormat format) throws IOException {
    byte[] there = converted(ALL.getBytes(StandardCharsets.UTF_8), format, new ProblemCollector());
    String back =
        new String(
            converted(there, SceneFormat.XML, new ProblemCollector()), StandardCharsets.UTF_8);
    assertThat(back)
        .contains("of the file", "of the world: a - -b", "of the kids", "of the collision");
  }

  @Test
  void numbersKeepTheirDigits() throws IOException {
    byte[] xml = ALL.getBytes(StandardCharsets.UTF_8);
    String classic =
        new String(
            converted(xml, SceneFormat.CLASSIC, new ProblemCollector()), StandardCharsets.UTF_8);
    assertThat(classic).contains("1.50 0 -2e-3,", "0xFF 007", "inputOutput SFFloat radius .50");
    String json =
        new String(
            converted(xml, SceneFormat.JSON, new ProblemCollector()), StandardCharsets.UTF_8);
    assertThat(json).contains("1.50,0,-2e-3,", "0,1,0.0]", "255,7]", "\"@value\": 0.50");
  }

  @Test
  void theCommasOfJsonStayThere() throws IOException {
    byte[] xml = ALL.getBytes(StandardCharsets.UTF_8);
    byte[] json = converted(xml, SceneFormat.JSON, new ProblemCollector());
    String back =
        new String(
            converted(json, SceneFormat.XML, new ProblemCollector()), StandardCharsets.UTF_8);
    assertThat(back).contains("1.50 0 -2e-3").doesNotContainPattern("='[-0-9. ]*,");
  }

  @Test
  void formerNamesOfFieldsBecomeThePresentOnes() throws IOException {
    String scene =
        "<X3D version='3.3' profile='Full'><Scene><LayerSet><Layer isPickable='false'/></LayerSet>"
            + "<Collision collide='false'/></Scene></X3D>";
    ProblemCollector problems = new ProblemCollector();
    byte[] xml = converted(scene.getBytes(StandardCharsets.UTF_8), SceneFormat.XML, problems);
    assertThat(problems.list()).isEmpty();
    assertThat(new String(xml, StandardCharsets.UTF_8))
        .contains("<Layer pickable='false'/>", "<Collision enabled='false'/>");
  }

  @Test
  void vrml97BecomesX3d() throws IOException {
    String wrl =
        """
        #VRML V2.0 utf8
        # the switch
        DEF S Switch { choice [ Group { } ] whichChoice 0 }
        Collision { collide FALSE children Shape { } }
        Script { eventIn SFTime go url "javascript: function go(v) { a < b; }" }
        """;
    ProblemCollector problems = new ProblemCollector();
    byte[] xml = converted(wrl.getBytes(StandardCharsets.UTF_8), SceneFormat.XML, problems);
    assertThat(problems.list()).isEmpty();
    assertThat(new String(xml, StandardCharsets.UTF_8))
        .isEqualTo(
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <X3D profile='Immersive' version='3.3'>
              <Scene>
                <!-- the switch -->
                <Switch DEF='S' whichChoice='0'>
                  <Group/>
                </Switch>
                <Collision enabled='false'>
                  <Shape/>
                </Collision>
                <Script>
                  <field name='go' type='SFTime' accessType='inputOnly'/>
                  <![CDATA[
            ecmascript: function go(v) { a < b; }
            ]]>
                </Script>
              </Scene>
            </X3D>
            """);
  }

  @Test
  void whatX3dDoesNotKnowIsToldAndLeftOut() throws IOException {
    String scene =
        "<X3D version='3.3'><Scene><Shape shadow='1'><Teapot/></Shape>\n"
            + "<Transform scale='1 2' class='c'><Box/></Transform></Scene></X3D>";
    ProblemCollector problems = new ProblemCollector();
    byte[] there = converted(scene.getBytes(StandardCharsets.UTF_8), SceneFormat.CLASSIC, problems);
    assertThat(new String(there, StandardCharsets.UTF_8))
        .isEqualTo("#X3D V3.3 utf8\n\nShape {\n}\nTransform {\n}\n");
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            "scene:1:34: Shape has no field shadow; it is left out",
            "scene:1:45: unknown element Teapot; it and its children are left out",
            "scene:2:19: scale: 3 numbers are needed, not 2; the default is used",
            "scene:2:24: ClassicVRML has no class for elements; this one and all others are left out",
            "scene:2:34: a Box is not allowed in a Transform; it is left out");
  }

  @Test
  void namesThatVrmlCannotWriteAreChangedAlike() throws IOException {
    String scene =
        "<X3D version='3.3'><Scene><Group DEF='a b'/><Group DEF='a_b'/><Group USE='a b'/>"
            + "</Scene></X3D>";
    byte[] there =
        converted(
            scene.getBytes(StandardCharsets.UTF_8), SceneFormat.CLASSIC, new ProblemCollector());
    assertThat(new String(there, StandardCharsets.UTF_8))
        .contains("DEF a_b_2 Group", "DEF a_b Group", "USE a_b_2\n");
  }

  private static String written(String scene, SceneFormat format) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    byte[] text = converted(scene.getBytes(StandardCharsets.UTF_8), format, problems);
    assertThat(problems.list()).isEmpty();
    return new String(text, StandardCharsets.UTF_8);
  }

  /** Python's ElementTree writes line ends in attributes so. */
  @ParameterizedTest
  @EnumSource(SceneFormat.class)
  void referencesToCharactersInNumbersAreResolved(SceneFormat format) throws IOException {
    String scene =
        """
        <X3D version='3.3'><Scene><Shape><IndexedFaceSet coordIndex='0 1 2 -1&#10;2 1 0 -1&#x20;'>
        <Coordinate point='0 0 0,&#10;1 0 0,&#9;0 &#49; 0'/></IndexedFaceSet></Shape>
        <PositionInterpolator key='0&#10;1' keyValue='1 2 3&#xA;4 5 6'/>
        <ProtoDeclare name='P'><ProtoInterface><field name='n' type='MFInt32'
        accessType='inputOutput' value='1&#10;2'/></ProtoInterface><ProtoBody><Group/></ProtoBody>
        </ProtoDeclare><ProtoInstance name='P'><fieldValue name='n' value='3&#10;4'/></ProtoInstance>
        </Scene></X3D>
        """;
    String text = written(scene, format);
    assertThat(text).doesNotContain("&");
    ProblemCollector problems = new ProblemCollector();
    assertThat(said(text.getBytes(StandardCharsets.UTF_8), problems))
        .isEqualTo(said(scene.getBytes(StandardCharsets.UTF_8), problems));
    assertThat(problems.list()).isEmpty();
  }

  /** Its default is another one in X3D 3 and in X3D 4, and other readers know one of them. */
  @Test
  void theFieldOfMetadataIsAlwaysWritten() throws IOException {
    String text =
        written(
            """
            <X3D version='4.0'><Scene><Group>
            <MetadataSet name='s' containerField='metadata'>
            <MetadataString name='t' containerField='value'/></MetadataSet></Group></Scene></X3D>
            """,
            SceneFormat.XML);
    assertThat(text)
        .contains("<MetadataSet containerField='metadata' name='s'>")
        .contains("<MetadataString containerField='value' name='t'/>");
  }

  @ParameterizedTest
  @EnumSource(SceneFormat.class)
  void importsOfBothSpellingsAreRead(SceneFormat format) throws IOException {
    String scene =
        """
        <X3D version='3.0'><Scene><Inline DEF='I' url='"a.x3d"'/>
        <IMPORT inlineDEF='I' exportedDEF='E' AS='F'/><IMPORT inlineDEF='I' exportedDEF='G'/>
        </Scene></X3D>
        """;
    List<X3dFile.Import> imports =
        READER
            .read(
                "scene",
                written(scene, format).getBytes(StandardCharsets.UTF_8),
                new ProblemCollector())
            .imports();
    assertThat(imports).extracting(X3dFile.Import::importedDef).containsExactly("E", "G");
    assertThat(imports).extracting(X3dFile.Import::as).containsExactly("F", "G");
    assertThat(READER.read("scene", scene, new ProblemCollector()).imports())
        .extracting(X3dFile.Import::importedDef)
        .containsExactly("E", "G");
  }
}
