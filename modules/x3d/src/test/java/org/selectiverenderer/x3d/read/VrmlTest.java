package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.source.XmlDocument;

/** ClassicVRML and VRML97 as scenes and as elements, with their places. */
class VrmlTest {
  private final ReaderFixture fixture = new ReaderFixture();

  /** A scene whose content starts at the second line. */
  private X3dFile classic(String content) {
    return fixture.read("#X3D V3.3 utf8\n" + content);
  }

  private X3dFile vrml97(String content) {
    return fixture.read("#VRML V2.0 utf8\n" + content);
  }

  private static XmlDocument document(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try {
      return new X3dReader(NodeCatalogue.load())
          .document("s.wrl", new ByteArrayInputStream(bytes), bytes.length);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Elements as XML would have them, a line each. */
  private static List<String> lines(String text) {
    List<String> lines = new ArrayList<>();
    for (DocumentElement element : document(text).elements()) {
      StringBuilder line = new StringBuilder();
      for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
        line.append(' ');
      }
      line.append(element.name());
      element
          .attributes()
          .forEach(a -> line.append(' ').append(a.name()).append('=').append(a.text()));
      lines.add(line.toString());
    }
    return lines;
  }

  @Test
  void aHeaderThatNamesX3dsVersionAfterVrmlIsThatOfX3d() {
    X3dFile file = fixture.read("#VRML V4.0 utf8\nPROFILE Full\nDEF A Group { }\n");
    fixture.assertClean();
    assertThat(file.version()).isEqualTo("4.0");
    assertThat(file.named()).containsOnlyKeys("A");
  }

  @Test
  void theHeadIsThatOfX3d() {
    X3dFile file =
        fixture.read(
            """
            #X3D V3.3 utf8
            # written by hand
            PROFILE Interchange
            COMPONENT Text:1 COMPONENT HAnim : 2
            META "title" "a \\"small\\" room"
            UNIT length inch 0.0254
            WorldInfo { }
            """);
    fixture.assertClean();
    assertThat(file.version()).isEqualTo("3.3");
    assertThat(file.profile()).isEqualTo("Interchange");
    assertThat(file.components()).containsEntry("Text", 1).containsEntry("HAnim", 2);
    assertThat(file.meta()).containsExactly(new X3dFile.Meta("title", "a \"small\" room"));
    assertThat(file.unitLength()).isEqualTo(0.0254);
    assertThat(file.nodes()).hasSize(1);
  }

  @Test
  void valuesOfEveryKindAreRead() {
    X3dFile file =
        classic(
            """
                Shape { appearance Appearance { texture
                  DEF A PixelTexture { image 2 1 1 0xFF 0x80 repeatS FALSE } }
                  geometry PointSet { coord DEF D Coordinate {
                    point [ 0 0 0, 1 2 3 # the corner ]
                      -1 .5 +2 ] } } }
                DEF B NavigationInfo { type [ "WALK", "ANY" ], speed 1.5e0 headlight TRUE }
                DEF C NavigationInfo { type "FLY" }
                DEF E WorldInfo { title "two
                lines \\\\ and \\"quotes\\"" info [ "x" "y # z" ] } # the end
                DEF F ColorInterpolator { key 0 keyValue [1 0 0] }
                """);
    fixture.assertClean();
    assertThat(file.named().get("A").ints("image")).containsExactly(2, 1, 1, 255, 128);
    assertThat(file.named().get("A").bool("repeatS")).isFalse();
    assertThat(file.named().get("D").floats("point")).containsExactly(0, 0, 0, 1, 2, 3, -1, .5f, 2);
    assertThat(file.named().get("B").strings("type")).containsExactly("WALK", "ANY");
    assertThat(file.named().get("B").number("speed")).isEqualTo(1.5f);
    assertThat(file.named().get("B").bool("headlight")).isTrue();
    assertThat(file.named().get("C").strings("type")).containsExactly("FLY");
    assertThat(file.named().get("E").string("title")).isEqualTo("two\nlines \\ and \"quotes\"");
    assertThat(file.named().get("E").strings("info")).containsExactly("x", "y # z");
    assertThat(file.named().get("F").floats("key")).containsExactly(0);
  }

  /** VTK and CadQuery write such files (ISO/IEC 14772-1, 4.6.2). */
  @Test
  void aNameGivenAgainInVrml97MeansTheLatestNodeSoFar() {
    X3dFile file =
        vrml97(
            """
            DEF P PositionInterpolator { }
            DEF A Transform { translation 1 0 0 children DEF A_2 Group { } }
            DEF B Group { children [ USE A USE A_2 ] }
            DEF A Transform { translation 2 0 0 }
            DEF C Group { children USE A }
            ROUTE P.value_changed TO A.set_translation
            PROTO Own [ ] { DEF A Group { } }
            DEF A Transform { translation 3 0 0 }
            """);
    fixture.assertClean();
    assertThat(file.named().keySet()).containsExactly("P", "A", "A_2", "B", "A_3", "C", "A_4");
    assertThat(List.<Object>copyOf(file.named().get("B").nodes("children")))
        .containsExactly(file.named().get("A"), file.named().get("A_2"));
    assertThat(List.<Object>copyOf(file.named().get("C").nodes("children")))
        .containsExactly(file.named().get("A_3"));
    assertThat(file.named().get("A_3").floats("translation")).containsExactly(2, 0, 0);
    assertThat(file.routes().get(0).to()).isSameAs(file.named().get("A_3"));
  }

  @Test
  void nodesStandInTheFieldThatIsNamed() {
    assertThat(
            lines(
                """
                #X3D V3.3 utf8
                Collision { proxy DEF P Shape { geometry Box { } } children [ USE P Group { } ] }
                Shape { appearance Appearance { texture NULL material Material { } } }
                MetadataSet { value MetadataFloat { value 1 } metadata MetadataString { } }
                """))
        .containsExactly(
            "X3D version=3.3",
            " Scene",
            "  Collision",
            "   Shape DEF=P containerField=proxy",
            "    Box",
            "   Shape USE=P",
            "   Group",
            "  Shape",
            "   Appearance",
            "    Material",
            "  MetadataSet",
            "   MetadataFloat value=1",
            "   MetadataString containerField=metadata");
  }

  @Test
  void aLayerIsPickableByTheNameOfX3d33() {
    X3dFile file = classic("PROFILE Full LayerSet { layers DEF L Layer { isPickable FALSE } }");
    fixture.assertClean();
    assertThat(file.named().get("L").bool("pickable")).isFalse();
  }

  @Test
  void theNamesOfVrml97BecomeThoseOfX3d() {
    X3dFile file =
        vrml97(
            """
            DEF S Switch { whichChoice 0 choice [ Group { } Shape { } ] }
            DEF L LOD { range 5 level [ Shape { } Shape { } ] }
            DEF C Collision { collide FALSE }
            DEF B TouchSensor { }
            ROUTE B.isActive TO C.set_collide
            ROUTE C.collide_changed TO B.enabled
            ROUTE L.level_changed TO S.set_choice
            """);
    fixture.assertClean();
    assertThat(file.profile()).isEqualTo("Immersive");
    assertThat(file.named().get("S").nodes("children")).hasSize(2);
    assertThat(file.named().get("L").nodes("children")).hasSize(2);
    assertThat(file.named().get("C").bool("enabled")).isFalse();
    assertThat(ReaderFixture.routes(file))
        .containsExactly(
            "B.isActive -> C.enabled", "C.enabled -> B.enabled", "L.children -> S.children");
  }

  @Test
  void prototypesAreThoseOfX3d() {
    X3dFile file =
        vrml97(
            """
            PROTO Ball [
              field SFFloat size 1  exposedField SFColor colour 1 0 0
              field MFNode more [ ]  eventOut SFTime touched  eventIn SFBool set_on ]
            {
              Transform {
                children [
                  Shape { geometry Sphere { radius IS size }
                          appearance Appearance { material Material { diffuseColor IS colour } } }
                  Group { children IS more }
                  TouchSensor { touchTime IS touched enabled IS set_on } ]
              }
            }
            DEF One Ball { size 2, more [ Group { } ] }
            DEF T TimeSensor { }
            ROUTE One.touched TO T.set_startTime
            USE One
            """);
    fixture.assertClean();
    ParsedNode ball = file.named().get("One");
    ParsedNode shape = (ParsedNode) ball.nodes("children").get(0);
    assertThat(shape.node("geometry").number("radius")).isEqualTo(2f);
    assertThat(ball.nodes("children").get(1).nodes("children")).hasSize(1);
    assertThat(file.routes()).hasSize(1);
    assertThat(file.nodes()).hasSize(3);
    assertThat(file.nodes().get(2)).isSameAs(ball);
  }

  @Test
  void externalPrototypesHaveTheirInterfaceAndUrls() {
    assertThat(
            lines(
                """
                #VRML V2.0 utf8
                EXTERNPROTO Chair [ field SFFloat height exposedField MFString names ]
                  [ "chairs.wrl#Chair", "old.wrl" ]
                Shape { appearance Chair { names [ "a" "b" ] height 3 } }
                """))
        .containsExactly(
            "X3D profile=Immersive version=3.3",
            " Scene",
            "  ExternProtoDeclare name=Chair url=\"chairs.wrl#Chair\", \"old.wrl\" ",
            "   field name=height type=SFFloat accessType=initializeOnly",
            "   field name=names type=MFString accessType=inputOutput",
            "  Shape",
            "   ProtoInstance name=Chair containerField=appearance",
            "    fieldValue name=names value=\"a\" \"b\" ",
            "    fieldValue name=height value=3");
  }

  @Test
  void scriptsDeclareTheirFields() {
    assertThat(
            lines(
                """
                #X3D V3.3 utf8
                PROTO P [ inputOnly SFBool go ] { Script { directOutput TRUE
                  inputOnly SFBool go IS go outputOnly SFTime done
                  initializeOnly SFNode target DEF T Transform { } inputOutput MFFloat all [ 1 2 ]
                  url "ecmascript: function go() { }" } }
                IMPORT Room.Door AS D EXPORT Wall AS W EXPORT Roof
                """))
        .containsExactly(
            "X3D version=3.3",
            " Scene",
            "  ProtoDeclare name=P",
            "   ProtoInterface",
            "    field name=go type=SFBool accessType=inputOnly",
            "   ProtoBody",
            "    Script directOutput=true url=\"ecmascript: function go() { }\"",
            "     field name=go type=SFBool accessType=inputOnly",
            "     field name=done type=SFTime accessType=outputOnly",
            "     field name=target type=SFNode accessType=initializeOnly",
            "      Transform DEF=T",
            "     field name=all type=MFFloat accessType=inputOutput value=1 2 ",
            "     IS",
            "      connect nodeField=go protoField=go",
            "  IMPORT inlineDEF=Room importedDEF=Door AS=D",
            "  EXPORT localDEF=Wall AS=W",
            "  EXPORT localDEF=Roof");
  }

  @Test
  void placesAreThoseOfTheText() {
    XmlDocument document =
        document(
            "#X3D V3.3 utf8\r\n# one\r\n  DEF A Transform {\n scale 1 two\t1 children Group{ }}");
    DocumentElement node = document.elements().get(2);
    assertThat(node.location()).hasToString("s.wrl:3:3");
    assertThat(node.last().orElseThrow()).hasToString("s.wrl:4:33");
    assertThat(node.attribute("scale").orElseThrow().location()).hasToString("s.wrl:4:2");
    assertThat(node.children().get(0).location()).hasToString("s.wrl:4:25");
    assertThat(document.comments()).hasSize(1);
    assertThat(document.comments().get(0).text()).isEqualTo(" one");
    assertThat(document.comments().get(0).before()).isSameAs(node);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "Group { children [ Shape { } }|2:18: the list of nodes that begins here has no closing",
        "Shape { geometry Box { }|2:25: the file is cut off here: a field or '}' is missing",
        "WorldInfo { title \"a }|2:19: the string that begins here has no closing quote",
        "Coordinate { point [ 0 0 0 }|2:20: the list that begins here has no closing ']'",
        "Group { } }|2:11: a node or a statement is expected here, not '}'",
        "ROUTE A.b C.d|2:11: TO and the destination of the ROUTE is expected here, not 'C.d'",
        "ROUTE A TO C.d|2:9: '.' between a node and its field, as in ROUTE Clock.isActive",
        "PROTO A [ field SFFlot x 1 ] { }|2:17: 'SFFlot' is not a field type",
        "PROTO A [ SFFloat x 1 ] { }|2:11: inputOnly, outputOnly, inputOutput or initializeOnly is",
        "META \"a\" b|2:1: META must stand before the first node of a scene",
        "Group META|2:7: '{' after the type of a node, 'Group', is expected here, not 'META'"
      })
  void whatBreaksTheGrammarEndsTheFile(String content, String problem) {
    X3dFile file = classic("Viewpoint { }\n" + content);
    assertThat(fixture.problems.list()).hasSizeBetween(1, 2);
    int last = fixture.problems.list().size() - 1;
    assertThat(fixture.problems.list().get(last).toString())
        .startsWith("test.x3d:" + problem.replaceFirst("^2", "3"))
        .endsWith("; the part before it is kept");
    assertThat(file.nodes()).isNotEmpty();
  }

  @Test
  void aValueThatIsWrongIsToldAtItsPlace() {
    classic(
        "Transform { scale 1 2 translation 1 2 3 4 }\nShape { geometry Box { size [ 1 2x 3 ] solid 1 } }");
    fixture.assertMessages(
        "test.x3d:2:19: scale: 3 numbers are needed, not 2; the default is used",
        "test.x3d:2:41: translation: 3 numbers are needed here; the rest is left out",
        "test.x3d:3:33: size: '2x' is not a number; 0 is used instead",
        "test.x3d:3:46: solid: '1' is neither true nor false; the default is used");
  }

  @Test
  void aWordForANumberIsToldAndTheFileGoesOn() {
    X3dFile file =
        classic(
            """
            Shape { geometry Sphere { radius abc } }
            Transform { translation nan nan 0 rotation nan 1 0 NaN scale big scaleOrientation 0 0 1 0 }
            Collision { enabled yes children Group { } }
            DEF G Group { }
            """);
    fixture.assertMessages(
        "test.x3d:2:34: radius: 'abc' is not a number; 0 is used instead",
        "test.x3d:3:25: translation: 'nan' is not a finite number; 0 is used instead",
        "test.x3d:3:29: translation: 'nan' is not a finite number; 0 is used instead",
        "test.x3d:3:44: rotation: 'nan' is not a finite number; 0 is used instead",
        "test.x3d:3:52: rotation: 'NaN' is not a finite number; 0 is used instead",
        "test.x3d:3:62: scale: 'big' is not a number; the default is used",
        "test.x3d:4:21: enabled: 'yes' is neither true nor false; the default is used");
    assertThat(file.named()).containsKey("G");
  }

  @Test
  void whatANodeDoesNotHaveIsPassedOver() {
    X3dFile file =
        classic(
            """
            Shape { shadow TRUE tint [ 1 0 0 ] name "x" mode FAST geometry Box { } }
            Teapot { parts [ Group { } ] handle Box { } amount 3 }
            DEF G Group { }
            """);
    fixture.assertMessages(
        "test.x3d:2:9: Shape has no field shadow; it is left out",
        "test.x3d:2:21: Shape has no field tint; it is left out",
        "test.x3d:2:36: Shape has no field name; it is left out",
        "test.x3d:2:45: Shape has no field mode; it is left out",
        "test.x3d:3:1: unknown element Teapot; it and its children are left out");
    assertThat(file.nodes().get(0).node("geometry")).isNotNull();
    assertThat(file.named()).containsKey("G");
  }

  @Test
  void aUseOfNothingIsTold() {
    classic("Group { children USE Nobody }");
    fixture.assertOnly("test.x3d:2:18: no node above has the name Nobody; the USE is left out");
  }

  @Test
  void depthAndNumberOfNodesAreLimited() {
    ReaderFixture small = new ReaderFixture(new ReadLimits(1 << 20, 1000, 10, 50));
    small.read("#X3D V3.3 utf8\n" + "Group { children ".repeat(1000));
    assertThat(small.problems.list().get(0).message()).contains("nested more than 10 deep");
    small.read("#VRML V2.0 utf8\n" + "Group { }".repeat(1000));
    assertThat(small.problems.list().get(0).message()).contains("more than 50 elements");
  }

  @Test
  void theControlPointsOfVrml97AreACoordinate() {
    X3dFile file =
        vrml97("Shape { geometry DEF N NurbsCurve { controlPoint [ 0 0 0, 1 1 1 ] order 2 } }");
    fixture.assertClean();
    assertThat(file.named().get("N").node("controlPoint").floats("point")).hasSize(6);
  }
}
