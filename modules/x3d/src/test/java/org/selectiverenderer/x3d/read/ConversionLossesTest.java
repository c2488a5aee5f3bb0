package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** What an encoding cannot hold is told with its place, and the rest can be read again. */
class ConversionLossesTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final X3dReader READER = new X3dReader(CATALOGUE);

  private ProblemCollector problems = new ProblemCollector();

  private static XmlDocument document(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return READER.document("scene", new ByteArrayInputStream(bytes), bytes.length);
  }

  private String converted(String scene, SceneFormat format) throws IOException {
    problems = new ProblemCollector();
    String text = format.text(document(scene), CATALOGUE, problems);
    assertThat(document(text).faults()).isEmpty();
    return text;
  }

  private static String scene(String content) {
    return "<X3D version='4.0' profile='Full'><Scene>\n" + content + "</Scene></X3D>";
  }

  private List<String> told() {
    return problems.list().stream().map(Problem::toString).toList();
  }

  @ParameterizedTest
  @EnumSource
  void aNodeThatIsNullIsNoValue(SceneFormat format) throws IOException {
    String scene =
        scene(
            """
            <ProtoDeclare name='P'><ProtoInterface>
            <field name='n' type='SFNode' accessType='inputOutput'/></ProtoInterface>
            <ProtoBody><Group/></ProtoBody></ProtoDeclare>
            <ProtoInstance name='P'><fieldValue name='n' value='null'/></ProtoInstance>
            <ProtoInstance name='P'><fieldValue name='n' value='Material'/></ProtoInstance>
            """);
    converted(scene, format);
    assertThat(told())
        .containsExactly(
            "scene:6:46: the value of this field must be a child element; it is left out");
  }

  @ParameterizedTest
  @EnumSource
  void aFieldNamedAsAnAttributeOfHtmlIsKept(SceneFormat format) throws IOException {
    String text = converted(scene("<Shape><Text><FontStyle style='BOLD'/></Text></Shape>"), format);
    assertThat(told()).isEmpty();
    assertThat(text).contains("BOLD");
  }

  @ParameterizedTest
  @EnumSource
  void controlCharactersAreToldWhereTheyAreForbidden(SceneFormat format) throws IOException {
    String scene = "#X3D V4.0 utf8\nPROFILE Full\nWorldInfo { title \"a\u0001b\" }\n";
    String text = converted(scene, format);
    if (format == SceneFormat.XML) {
      assertThat(told())
          .containsExactly(
              "scene:3:13: X3D XML cannot hold the character U+0001 here; U+FFFD is written"
                  + " instead");
      assertThat(text).contains("title='a\ufffdb'");
    } else {
      assertThat(told()).isEmpty();
    }
  }

  @ParameterizedTest
  @EnumSource
  void declarationsThatAreNoneAreLeftOut(SceneFormat format) throws IOException {
    converted(
        scene(
            """
            <Script><field name='a' type='SFFoo' accessType='inputOutput'/>
            <field name='b' type='SFBool' accessType='exposedField'/></Script>
            <ROUTE fromNode='A' fromField='b' toNode='C'/>
            """),
        format);
    String field =
        "a field needs a type such as SFFloat, and one of the accessTypes initializeOnly,"
            + " inputOnly, outputOnly and inputOutput; this one is left out";
    assertThat(told())
        .containsExactly(
            "scene:2:9: " + field,
            "scene:3:1: " + field,
            "scene:4:1: ROUTE needs fromNode, fromField, toNode, toField; this one is left out");
  }

  @Test
  void namesThatVrmlCannotWriteAreTold() throws IOException {
    String text =
        converted(
            scene(
                """
                <Script DEF='1st'><field name='my value' type='SFFloat' accessType='inputOutput'/>
                </Script><Script DEF='my_value'>
                <field name='in' type='SFFloat' accessType='inputOnly'/></Script>
                <ROUTE fromNode='1st' fromField='my value_changed' toNode='my_value' toField='in'/>
                """),
            SceneFormat.CLASSIC);
    assertThat(text)
        .contains("DEF _1st Script", "my_value 0", "ROUTE _1st.my_value_changed TO my_value.in");
    assertThat(told())
        .containsExactly(
            "scene:2:26: ClassicVRML cannot have the name 'my value'; it becomes 'my_value'",
            "scene:2:9: ClassicVRML cannot have the name '1st'; it becomes '_1st'");
  }

  @ParameterizedTest
  @EnumSource
  void annotationsOfPrototypesAreKeptOrTold(SceneFormat format) throws IOException {
    String text =
        converted(
            scene(
                """
                <ExternProtoDeclare name='E' url='"e.x3d#E"' appinfo='shows e'>
                <field name='a' type='SFBool' accessType='inputOutput' documentation='on or off'/>
                </ExternProtoDeclare>
                """),
            format);
    assertThat(text).contains("shows e", "on or off");
    if (format == SceneFormat.CLASSIC) {
      assertThat(text).contains("# appinfo: shows e\n", "# documentation: on or off\n");
      assertThat(told())
          .containsExactly(
              "scene:2:46: ClassicVRML has no appinfo; it becomes a comment",
              "scene:3:56: ClassicVRML has no documentation; it becomes a comment");
    } else {
      assertThat(told()).isEmpty();
    }
  }

  /** VRML needs a value for each field, and 0 would be another scene. */
  @Test
  void fieldsOfPrototypesWithoutAValueHaveThatOfTheNode() throws IOException {
    String text =
        converted(
            scene(
                """
                <ProtoDeclare name='Ball'><ProtoInterface>
                <field name='size' type='SFFloat' accessType='inputOutput'/>
                <field name='color' type='SFColor' accessType='inputOutput'/></ProtoInterface>
                <ProtoBody><Shape><Sphere radius='3'><IS>
                <connect nodeField='radius' protoField='size'/></IS></Sphere><Appearance><Material>
                <IS><connect nodeField='diffuseColor' protoField='color'/></IS></Material>
                </Appearance></Shape></ProtoBody></ProtoDeclare><ProtoInstance name='Ball'/>
                """),
            SceneFormat.CLASSIC);
    assertThat(text).contains("SFFloat size 3", "SFColor color 0.8 0.8 0.8");
    assertThat(told()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource
  void whatIsOutsideOfItsPlaceIsLeftOut(SceneFormat format) throws IOException {
    converted(
        "<X3D version='4.0' profile='Full'><head><ROUTE fromNode='A' fromField='a' toNode='B'"
            + " toField='b'/></head><Group/><Scene><meta name='m'/><Scene/></Scene></X3D>",
        format);
    assertThat(told())
        .containsExactly(
            "scene:1:41: ROUTE is not allowed in head; it is left out",
            "scene:1:106: a Group is not allowed in X3D; it is left out",
            "scene:1:121: meta is not allowed in Scene; it is left out",
            "scene:1:137: Scene is not allowed in Scene; it is left out");
  }

  /** The search for AS behind an EXPORT must not take the comment twice. */
  @Test
  void commentsStayOne() throws IOException {
    String text =
        converted(
            "#X3D V4.0 utf8\nPROFILE Full\nDEF A Group { }\nEXPORT A # once\nGroup { }\n",
            SceneFormat.XML);
    assertThat(text).containsOnlyOnce("once");
  }

  @ParameterizedTest
  @EnumSource
  void programsKeepTheirLines(SceneFormat format) throws IOException {
    String text = converted(scene("<Script url='\"ecmascript: // one\n two\"'/>"), format);
    XmlDocument again = document(text);
    X3dFile file = READER.scene(again, new ProblemCollector());
    ParsedNode script = file.nodes().get(0);
    Object code = script.value(script.type().indexOf("sourceCode"));
    Object urls = script.value(script.type().indexOf("url"));
    String all = code + String.join("", (String[]) urls);
    assertThat(all).contains("// one\n two");
  }
}
