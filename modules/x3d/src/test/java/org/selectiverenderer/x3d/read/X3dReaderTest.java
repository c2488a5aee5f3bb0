package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;

class X3dReaderTest {
  private final ReaderFixture fixture = new ReaderFixture();

  private X3dFile scene(String content) {
    return fixture.scene(content);
  }

  @Test
  void readsTheHead() {
    X3dFile file =
        fixture.read(
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "https://example.invalid/x3d-3.3.dtd">
            <X3D profile="Immersive" version="3.3" xmlns:xsd="http://www.w3.org/2001/XMLSchema-instance"
                 xsd:noNamespaceSchemaLocation="https://example.invalid/x3d-3.3.xsd">
              <head>
                <component name="Shape" level="4"/>
                <unit category="length" name="millimetre" conversionFactor="0.001"/>
                <meta name="title" content="a &amp; b"/>
              </head>
              <Scene/>
            </X3D>
            """);
    fixture.assertClean();
    assertThat(file.version()).isEqualTo("3.3");
    assertThat(file.profile()).isEqualTo("Immersive");
    assertThat(file.components()).containsEntry("Shape", 4);
    assertThat(file.units()).containsExactly(new X3dFile.Unit("length", "millimetre", 0.001));
    assertThat(file.meta()).containsExactly(new X3dFile.Meta("title", "a & b"));
    assertThat(file.nodes()).isEmpty();
  }

  @Test
  void readsNodesWithTheirFieldsAndPlaces() {
    X3dFile file =
        scene(
            """
            <Transform DEF='T' translation='1 2 3'>
              <Shape>
                <Appearance><Material diffuseColor='1 0 0' class='x' id='y' style='z'/></Appearance>
                <IndexedFaceSet coordIndex='0 1 2 -1'>
                  <Coordinate point='0 0 0, 1 0 0, 0 1 0'/>
                </IndexedFaceSet>
              </Shape>
            </Transform>
            """);
    fixture.assertClean();
    ParsedNode transform = file.nodes().get(0);
    assertThat(transform.name()).isEqualTo("T");
    assertThat(transform.location()).isEqualTo(new SourceLocation("test.x3d", 2, 1));
    assertThat(transform.floats("translation")).containsExactly(1, 2, 3);
    assertThat(transform.floats("scale")).containsExactly(1, 1, 1);
    assertThat(transform.given(transform.type().indexOf("scale"))).isFalse();
    NodeView shape = transform.nodes("children").get(0);
    assertThat(shape.location()).isEqualTo(new SourceLocation("test.x3d", 3, 3));
    assertThat(shape.node("appearance").node("material").floats("diffuseColor"))
        .containsExactly(1, 0, 0);
    assertThat(shape.node("geometry").ints("coordIndex")).containsExactly(0, 1, 2, -1);
    assertThat(shape.node("geometry").node("coord").floats("point")).hasSize(9);
    assertThat(file.named()).containsExactly(java.util.Map.entry("T", transform));
  }

  @Test
  void aUsedNodeIsTheSameObject() {
    X3dFile file = scene("<Shape DEF='S'/><Group><Shape USE='S'/></Group>");
    fixture.assertClean();
    assertThat(file.nodes().get(1).nodes("children").get(0)).isSameAs(file.nodes().get(0));
  }

  @Test
  void aUseBeforeItsDefIsLeftOut() {
    X3dFile file = scene("<Group><Shape USE='Desk'/></Group>\n<Shape DEF='Desk'/>");
    fixture.assertOnly("test.x3d:2:15: no node above has the name Desk; the USE is left out");
    assertThat(file.nodes().get(0).nodes("children")).isEmpty();
  }

  @Test
  void aMisspeltUseIsProposed() {
    scene("<Shape DEF='Desk'/><Shape USE='desk'/>");
    fixture.assertOnly(
        "test.x3d:2:27: no node above has the name desk (did you mean Desk?); the "
            + "USE is left out");
  }

  @Test
  void aNodeCannotBecomeAPartOfItself() {
    X3dFile file = scene("<Group DEF='G'><Group><Group USE='G'/></Group></Group>");
    fixture.assertOnly("test.x3d:2:30: G would contain itself here; the USE is left out");
    assertThat(file.nodes().get(0).nodes("children")).hasSize(1);
  }

  @Test
  void theLaterOfTwoEqualNamesWins() {
    X3dFile file = scene("<Shape DEF='A'/><Group DEF='A'/><Group USE='A'/>");
    fixture.assertOnly(
        "test.x3d:2:17: the name A is used already at test.x3d:2:1; from here on it "
            + "means this Group");
    assertThat(file.nodes().get(2)).isSameAs(file.nodes().get(1));
  }

  @Test
  void anUnknownElementIsLeftOutWithItsChildren() {
    X3dFile file = scene("<Group/>\n  <Transfrom><Shape/></Transfrom>\n<Group/>");
    fixture.assertOnly(
        "test.x3d:3:3: unknown element Transfrom (did you mean Transform?);"
            + " it and its children are left out");
    assertThat(file.nodes()).hasSize(2);
  }

  @Test
  void anUnknownAttributeIsToldAtItsPlace() {
    scene("<Transform\n    translation='1 2 3'\n    rotatoin='0 1 0 1'/>");
    fixture.assertOnly(
        "test.x3d:4:5: Transform has no field rotatoin (did you mean rotation?); it is left out");
  }

  @Test
  void attributesThatAreNoValuesAreTold() {
    scene("<Shape geometry='Box'/><ProximitySensor isActive='true'/>");
    fixture.assertOnly(
        "test.x3d:2:8: geometry of Shape must be a child element; the attribute is left out",
        "test.x3d:2:41: isActive of ProximitySensor is for events and cannot have a "
            + "value in a file; it is left out");
  }

  @Test
  void aBadValueIsToldAtTheOffendingWord() {
    X3dFile file = scene("<Coordinate DEF='C'\n point='\n  0 &#48; 0,\r\n 1 abc 1,\r 2 2'/>");
    fixture.assertMessages(
        "test.x3d:5:4: point: 'abc' is not a number; 0 is used instead",
        "test.x3d:6:2: point: the last value has only 2 of its 3 numbers; they are left out",
        "test.x3d:2:1: a Coordinate at the top of a scene is not shown; put it into "
            + "another node");
    assertThat(file.named().get("C").floats("point")).containsExactly(0, 0, 0, 1, 0, 1);
  }

  @Test
  void placesCountCharactersNotBytes() {
    X3dFile file = scene("<WorldInfo title='Büro €'/><Transfrom/>\n<Text string='\"Tür\" x'/>");
    fixture.assertMessages(
        "test.x3d:2:28: unknown element Transfrom (did you mean Transform?);"
            + " it and its children are left out",
        "test.x3d:3:21: string: 'x' is outside of quotes; it is used as a string",
        "test.x3d:3:1: a Text at the top of a scene is not shown; put it into another node");
    assertThat(file.nodes().get(0).string("title")).isEqualTo("Büro €");
  }

  @Test
  void putsChildrenIntoTheFieldThatTheyName() {
    X3dFile file =
        scene(
            """
            <WorldInfo><MetadataSet containerField='metadata' name='m'>
              <MetadataString containerField='value' name='a' value='"x"'/>
              <MetadataFloat containerField='value' name='b' value='1'/>
              <MetadataString containerField='metadata' name='c'/>
            </MetadataSet></WorldInfo>
            <Switch><Group containerField='choice'/><Group containerField='children'/></Switch>
            <LOD><Group containerField='level'/></LOD>
            """);
    fixture.assertClean();
    NodeView set = file.nodes().get(0).node("metadata");
    assertThat(set.nodes("value"))
        .extracting(node -> node.string("name"))
        .containsExactly("a", "b");
    assertThat(set.node("metadata").string("name")).isEqualTo("c");
    assertThat(file.nodes().get(1).nodes("children")).hasSize(2);
    assertThat(file.nodes().get(2).nodes("children")).hasSize(1);
  }

  @Test
  void metadataFindsItsFieldByItself() {
    X3dFile file =
        scene("<Group><MetadataSet name='m'><MetadataString name='a'/></MetadataSet></Group>");
    fixture.assertClean();
    assertThat(file.nodes().get(0).node("metadata").nodes("value")).hasSize(1);
  }

  @Test
  void aChildInTheWrongFieldGoesWhereItFits() {
    X3dFile file = scene("<Shape><Box containerField='children'/></Shape>");
    fixture.assertOnly(
        "test.x3d:2:8: a Box does not fit into children of a Shape; it is used as "
            + "its geometry");
    assertThat(file.nodes().get(0).node("geometry").type().name()).isEqualTo("Box");
  }

  @Test
  void namesWithinAnUnknownElementNeedNoMessageOfTheirOwn() {
    scene(
        """
        <Teapot DEF='T'><Group DEF='G'><TimeSensor DEF='C'/></Group></Teapot>
        <Group USE='G'/><TimeSensor DEF='D'/>
        <ROUTE fromNode='T' fromField='a' toNode='D' toField='enabled'/>
        <ROUTE fromNode='D' fromField='isActive' toNode='C' toField='enabled'/>
        <ROUTE fromNode='D' fromField='isActive' toNode='E' toField='enabled'/>
        """);
    fixture.assertOnly(
        "test.x3d:2:1: unknown element Teapot; it and its children are left out",
        "test.x3d:6:1: no node has the name E (did you mean D?); the ROUTE D.isActive to E.enabled"
            + " is left out");
  }

  @Test
  void namesHaveTheRightArticle() {
    scene("<Inline><ImageTexture/></Inline><LOD><CADPart/><Appearance/></LOD>");
    fixture.assertOnly(
        "test.x3d:2:9: an ImageTexture is not allowed in an Inline; it is left out",
        "test.x3d:2:48: an Appearance is not allowed in an LOD; it is left out");
  }

  @Test
  void aChildThatFitsNowhereIsLeftOut() {
    scene("<Group><Box/></Group><Shape><Box/><Sphere/></Shape>");
    fixture.assertOnly(
        "test.x3d:2:8: a Box is not allowed in a Group; it is left out",
        "test.x3d:2:35: the geometry of a Shape can be only one node, and there is "
            + "one already; this Sphere is left out");
  }

  @Test
  void keepsAScriptWithItsSource() {
    X3dFile file =
        scene(
            """
            <Script DEF='S'><field name='in' type='SFBool' accessType='inputOnly'/>
            <field name='n' type='SFNode' accessType='initializeOnly'><Group DEF='Inner'/></field>
            <![CDATA[ecmascript: function f() { return 1 < 2; }]]></Script>
            <TouchSensor DEF='T'/><ROUTE fromNode='T' fromField='isActive' toNode='S' toField='in'/>
            <Group USE='Inner'/>
            """);
    assertThat(file.nodes().get(0).string("sourceCode"))
        .isEqualTo("ecmascript: function f() { return 1 < 2; }");
    assertThat(fixture.problems.list()).isEmpty();
    assertThat(file.nodes()).hasSize(3);
    assertThat(file.routes()).hasSize(1);
  }

  @Test
  void fieldsOfAScriptAreItsOwn() {
    X3dFile file =
        scene(
            """
            <Group DEF='G'><Script DEF='S'>
              <field name='size' type='MFFloat' accessType='inputOutput' value='1 2 3'/>
              <field name='around' type='SFNode' accessType='initializeOnly'><Group USE='G'/></field>
              <field name='none' type='SFVec3f' accessType='outputOnly'/>
            </Script></Group>
            <Script DEF='Other'/>
            """);
    ParsedNode script = file.named().get("S");

    assertThat(script.floats("size")).containsExactly(1, 2, 3);
    assertThat(script.node("around")).isSameAs(file.named().get("G"));
    assertThat(script.floats("none")).containsExactly(0, 0, 0);
    assertThat(script.type().name()).isEqualTo("Script");
    assertThat(script.type().is("X3DScriptNode")).isTrue();
    assertThat(script.type().ownFrom()).isEqualTo(file.named().get("Other").type().fields().size());
    assertThat(file.named().get("Other").type().field("size")).isEmpty();
    assertThat(fixture.problems.list()).isEmpty();
  }

  @Test
  void programsKnowWhereTheyStand() {
    X3dFile file =
        scene(
            """
            <Script DEF='Text'><field name='a' type='SFBool' accessType='inputOnly'/>
              <!-- a comment -->
              <![CDATA[

                ecmascript: var a;]]></Script>
            <Script DEF='Url' url='"no.js" "javascript: var b;"'/>
            """);
    SourceLocation scene = file.named().get("Text").location();

    assertThat(file.named().get("Text").textLocation())
        .isEqualTo(new SourceLocation(scene.file(), scene.line() + 4, 5));
    assertThat(file.named().get("Url").textLocation())
        .isEqualTo(new SourceLocation(scene.file(), scene.line() + 5, 44));
  }

  @Test
  void keepsImportsAndExports() {
    X3dFile file =
        scene(
            """
            <Inline DEF='I' url='"a.x3d"'/>
            <IMPORT inlineDEF='I' importedDEF='Door' AS='D'/>
            <EXPORT localDEF='I'/><EXPORT localDEF='J' AS='K'/>
            <ROUTE fromNode='D' fromField='x' toNode='I' toField='load'/>
            """);
    assertThat(file.imports().get(0).as()).isEqualTo("D");
    assertThat(file.exports()).hasSize(1);
    assertThat(file.exports().get(0).as()).isEqualTo("I");
    assertThat(file.importedRoutes().get(0).from()).isEqualTo(new X3dFile.End.Imported("D", "x"));
    fixture.assertMessages(
        "test.x3d:4:23: no node has the name J (did you mean I?); the EXPORT is left out");
  }

  @Test
  void readsAllUsualEncodings() {
    String text = "<X3D version='4.0'><Scene><WorldInfo title='Gr\u00fcn'/></Scene></X3D>";
    for (Charset charset :
        new Charset[] {
          StandardCharsets.UTF_8,
          StandardCharsets.UTF_16BE,
          StandardCharsets.UTF_16LE,
          StandardCharsets.ISO_8859_1
        }) {
      boolean latin = charset.equals(StandardCharsets.ISO_8859_1);
      for (String mark : latin ? new String[] {""} : new String[] {"", "\ufeff"}) {
        for (String declared :
            new String[] {"", "<?xml version='1.0' encoding='" + charset + "'?>\n"}) {
          if (latin && declared.isEmpty()) {
            continue;
          }
          X3dFile file = fixture.read((mark + declared + text).getBytes(charset));
          assertThat(file.nodes().get(0).string("title")).as(charset + mark).isEqualTo("Gr\u00fcn");
          int line = declared.isEmpty() ? 1 : 2;
          assertThat(file.nodes().get(0).location())
              .isEqualTo(new SourceLocation("test.x3d", line, 27));
        }
      }
    }
    fixture.assertClean();
    fixture.read("\ufeff<X3D><Scene><Teapot/></Scene></X3D>".getBytes(StandardCharsets.UTF_8));
    fixture.assertOnly("test.x3d:1:13: unknown element Teapot; it and its children are left out");
  }

  @Test
  void readsBytesThatAreNotTheEncodingTheyClaim() {
    X3dFile file =
        fixture.read(
            "<X3D><Scene><WorldInfo title='Gr\u00fcn'/></Scene></X3D>"
                .getBytes(StandardCharsets.ISO_8859_1));
    assertThat(file.nodes().get(0).string("title")).isEqualTo("Gr\u00fcn");
    fixture.assertOnly(
        "test.x3d: the file has bytes that are not valid UTF-8; it is read as ISO-8859-1");
  }
}
