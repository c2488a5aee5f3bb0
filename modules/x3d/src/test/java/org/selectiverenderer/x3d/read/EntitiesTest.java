package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Entities that the DOCTYPE of a scene declares are expanded; those of other files are not. */
class EntitiesTest {
  private static final String SUBSET =
      """
      <!DOCTYPE X3D [
        <!ENTITY wood "0.4 0.2 0.1"><!ENTITY room 'kitchen'><!ENTITY name 'Area_&room;'>
        <!ENTITY quoted '"&room;" "b"'><!ENTITY colour "<Material diffuseColor='&wood;'/>">
        <!ENTITY chair "<Shape DEF='Chair'><Appearance>&colour;</Appearance><Box/></Shape>">
        <!ENTITY points "0 0 0, 1 1 1"><!ENTITY half "<Group>"><!ENTITY empty "">
        <!ENTITY loop "&pool;"><!ENTITY pool "&loop;"><!ENTITY % outside SYSTEM "x.dtd">
      ]>
      """;

  private final ReaderFixture fixture = new ReaderFixture();

  /** A scene whose content starts at line 9. */
  private X3dFile scene(String content) {
    return fixture.read(SUBSET + "<X3D version='4.0'><Scene>\n" + content + "\n</Scene></X3D>");
  }

  private static XmlDocument document(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    return reader.document("test.x3d", new ByteArrayInputStream(bytes), bytes.length);
  }

  private static List<String> faults(XmlDocument document) {
    return document.faults().stream().map(f -> f.location() + ": " + f.message()).toList();
  }

  @Test
  void expandsAttributeValues() throws IOException {
    String content =
        """
        <PositionInterpolator DEF='&name;' key='0 .2 .4 1' keyValue='&points;, &points;'/>
        <MetadataString value='&quoted;'/><MetadataString value="&quoted;"/>
        <Group/>""";
    assertThat(scene(content).nodes()).hasSize(4);
    fixture.assertClean();
    XmlDocument document = document(SUBSET + "<X3D><Scene>\n" + content + "</Scene></X3D>");
    assertThat(document.faults()).isEmpty();
    List<DocumentElement> elements = document.elements();
    assertThat(elements.get(2).def()).contains("Area_kitchen");
    assertThat(elements.get(2).text("keyValue")).contains("0 0 0, 1 1 1, 0 0 0, 1 1 1");
    assertThat(elements.get(3).text("value")).contains("\"kitchen\" \"b\"");
    assertThat(elements.get(4).text("value")).contains("\"kitchen\" \"b\"");
    assertThat(elements.get(4).location()).hasToString("test.x3d:10:35");
    assertThat(elements.get(5).location()).hasToString("test.x3d:11:1");
  }

  @Test
  void expandsElementContent() throws IOException {
    String content = "<Group>&empty;&chair;<Group/></Group>\n<Shape USE='Chair'/>";
    X3dFile file = scene(content);
    fixture.assertClean();
    assertThat(file.nodes()).hasSize(2);
    XmlDocument document = document(SUBSET + "<X3D><Scene>\n" + content + "</Scene></X3D>");
    assertThat(document.elements())
        .extracting(element -> element.name() + " " + element.location().column())
        .containsExactly(
            "X3D 1",
            "Scene 6",
            "Group 1",
            "Shape 15",
            "Appearance 15",
            "Material 15",
            "Box 15",
            "Group 22",
            "Shape 1");
    assertThat(document.elements().get(5).text("diffuseColor")).contains("0.4 0.2 0.1");
  }

  @Test
  void problemsAreLocatedAtTheReference() {
    scene("<Group/>\n <Transform scale='1 &room; 1'/><Group bboxSize='1 x 1'/>");
    assertThat(fixture.problems.list()).hasSize(2);
    assertThat(fixture.problems.list().get(0).location()).hasToString("test.x3d:10:22");
    assertThat(fixture.problems.list().get(1).location()).hasToString("test.x3d:10:52");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "nowhere | the entity &nowhere; is not declared in the DOCTYPE of this file",
        "loop | the entity &loop; refers to itself",
        "half | the entity &half; has an element that does not begin and end in it",
      })
  void keepsTheRestOfAnInvalidReferenceInContent(String name, String message) throws IOException {
    String content = "<Group/> &" + name + "; <Group/>";
    assertThat(scene(content).nodes()).hasSize(2);
    fixture.assertOnly("test.x3d:9:10: " + message + "; it is left out");
    XmlDocument document = document(SUBSET + "<X3D><Scene>\n" + content + "</Scene></X3D>");
    assertThat(faults(document)).containsExactly("test.x3d:9:10: " + message);
    assertThat(document.faults().get(0).kind()).isEqualTo(DocumentError.Kind.ENTITY);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "nowhere | the entity &nowhere; is not declared in the DOCTYPE of this file",
        "pool | the entity &pool; cannot be expanded: the entity &loop; refers to itself",
        "chair | the entity &chair; has a '<', which the value of an attribute must not have",
      })
  void readingEndsAtAnInvalidReferenceInAnAttribute(String name, String message) {
    String before = "<WorldInfo title='&room;'/>";
    assertThat(scene(before + "<Group DEF='&" + name + ";'/>").nodes()).hasSize(1);
    fixture.assertOnly("test.x3d:9:40: " + message + "; the part before it is kept");
  }

  @Test
  void referencesInCommentsAndCdataAreText() {
    scene("<!-- &nowhere; &loop; --><Script><![CDATA[ecmascript: var a = b &room; c;]]></Script>");
    fixture.assertClean();
  }

  @Test
  void externalEntitiesAreNotRead(@TempDir Path folder) throws IOException {
    Path secret = Files.writeString(folder.resolve("secret.xml"), "<Group DEF='Secret'/>");
    Path dtd = Files.writeString(folder.resolve("x.dtd"), "<!ENTITY outside 'x'>");
    String text =
        "<!DOCTYPE X3D SYSTEM '"
            + dtd.toUri()
            + "' [<!ENTITY far SYSTEM '"
            + secret.toUri()
            + "'>"
            + "<!ENTITY % p SYSTEM '"
            + dtd.toUri()
            + "'> %p; <!ENTITY inner '&far;'>]>\n"
            + "<X3D><Scene>\n<Group/>&far;&inner;<WorldInfo title='&outside;'/></Scene></X3D>";
    X3dFile file = fixture.read(text);
    assertThat(file.nodes()).hasSize(1);
    fixture.assertOnly(
        "test.x3d:3:9: the entity &far; is external and is never fetched; it is left out",
        "test.x3d:3:14: the entity &inner; cannot be expanded: the entity &far; is external and is"
            + " never fetched; it is left out",
        "test.x3d:3:39: the entity &outside; is not declared in the DOCTYPE of this file; the part"
            + " before it is kept");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "lol"})
  void nestedEntitiesDoNotExhaustMemory(String leaf) {
    StringBuilder subset = new StringBuilder("<!DOCTYPE X3D [<!ENTITY e0 '" + leaf + "'>");
    for (int i = 1; i < 15; i++) {
      subset.append("<!ENTITY e%d '%s'>".formatted(i, ("&e" + (i - 1) + ";").repeat(1000)));
    }
    String start = subset + "]>\n<X3D><Scene>\n<Group/>";
    assertThat(fixture.read(start + "&e14;<Group/></Scene></X3D>").nodes()).isNotEmpty();
    fixture.assertOnly(
        leaf.isEmpty()
            ? "test.x3d:3:9: the entities of the DOCTYPE expand to more than 16777216 characters,"
                + " which is not plausible for a scene; the part before it is kept"
            : "test.x3d:3:9: the entity &e14; cannot be expanded: the entity &e2; stands for more"
                + " than 65536 characters; it is left out");
  }

  @Test
  void allExpansionsOfAFileAreBounded() throws IOException {
    String text =
        "<!DOCTYPE X3D [<!ENTITY w '"
            + "w".repeat(60_000)
            + "'>]>\n<X3D><Scene><Group/>\n"
            + "<WorldInfo info='\"&w;\"'/>\n".repeat(400)
            + "</Scene></X3D>";
    ReaderFixture large = new ReaderFixture();
    assertThat(large.read(text).nodes()).hasSizeBetween(200, 300);
    assertThat(large.problems.list()).hasSize(1);
    assertThat(large.problems.list().get(0).toString())
        .startsWith("test.x3d:282:19: the entities of the DOCTYPE expand to more than 16777216");
    assertThat(document(text).faults())
        .extracting(DocumentError::kind)
        .containsExactly(DocumentError.Kind.LIMIT);
  }
}
