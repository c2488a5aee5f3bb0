package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** Scenes within pages of HTML and XHTML, as X3DOM shows them. */
class PageTest {
  private static final String PAGE =
      """
      <!DOCTYPE html>
      <html><head><title>A <x3d> in a title</title>
      <script>if (1 < 2) document.write("<x3d><scene></scene></x3d>");</script>
      <style>x3d > canvas { border: 0 }</style>
      <!-- <x3d><scene><shape></shape></scene></x3d> -->
      </head><body class=dark><p>A box:<br>
      <X3D id='x' width='400px' showStat=true onclick="go()">
      <Scene render>
        <viewpoint position='0 0 5' fieldofview=0.7></viewpoint>
        <transform DEF="Box" translation="1 2 3" class='a' data-x='b'>
          <Shape><Appearance><material diffusecolor='1 0 0'/></Appearance><box size='2 2 2'></box></shape>
        </transform>
        <!-- a text -->
        <shape><text string='"caf&#233; &amp; tea &lt; 5"'></text></shape>
        <inline url="a.x3d?b=1&c=2"></inline>
      </Scene>
      </X3D>
      </p></body></html>
      """;

  private final ReaderFixture fixture = new ReaderFixture();

  private static XmlDocument document(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try {
      return new X3dReader(NodeCatalogue.load())
          .document("page.html", new ByteArrayInputStream(bytes), bytes.length);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static List<String> elements(String text) {
    return document(text).elements().stream().map(PageTest::line).toList();
  }

  private static String line(DocumentElement element) {
    StringBuilder line = new StringBuilder(element.name());
    element
        .attributes()
        .forEach(a -> line.append(' ').append(a.name()).append('=').append(a.text()));
    return line.toString();
  }

  @Test
  void referencesInNumbersAreResolvedAndManyThatAreNoneTakeNoTime() {
    assertThat(elements("<html><x3d><scene><transform translation='1&#10;2&#xA;3'></transform>"))
        .contains("Transform translation=1\n2\n3");
    String ampersands = "&".repeat(2_000_000); // a search for each ';' took hours
    assertThat(elements("<html><x3d><scene><inline url='" + ampersands + "'></inline>"))
        .contains("Inline url=\"" + ampersands + "\"");
  }

  @Test
  void aLongerNameDoesNotEndAScript() {
    assertThat(
            elements("<html><script>a</scripty><x3d><scene><box/></script ><x3d><scene><group/>"))
        .contains("Group")
        .doesNotContain("Box");
  }

  @Test
  void theSceneOfAPageIsReadWithTheNamesOfX3d() {
    assertThat(elements(PAGE))
        .containsExactly(
            "X3D profile=Full version=4.0",
            "Scene",
            "Viewpoint position=0 0 5 fieldOfView=0.7",
            "Transform DEF=Box translation=1 2 3",
            "Shape",
            "Appearance",
            "Material diffuseColor=1 0 0",
            "Box size=2 2 2",
            "Shape",
            "Text string=\"café & tea < 5\"",
            "Inline url=\"a.x3d?b=1&c=2\"");
    X3dFile file = fixture.read(PAGE);
    fixture.assertClean();
    assertThat(file.named()).containsOnlyKeys("Box");
    assertThat(document(PAGE).comments()).extracting(c -> c.text()).containsExactly(" a text ");
    assertThat(document(PAGE).encoding()).isEqualTo(SceneEncoding.PAGE);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<!DOCTYPE HTML PUBLIC '-//W3C//DTD HTML 4.01//EN'>\n<html>%s</html>",
        "<?xml version='1.0' encoding='UTF-8'?>\n<!-- a page -->\n<!DOCTYPE html>\n"
            + "<html xmlns='http://www.w3.org/1999/xhtml'><head><script src='x3dom.js'/></head>"
            + "<body>%s</body></html>",
        "<HTML>%s",
        "<x3d>%s</x3d>",
      })
  void pagesAreKnownByTheirFirstElement(String page) {
    String scene = "<scene><group DEF='G'/></scene>";
    String inside = page.startsWith("<x3d") ? scene : "<x3d>" + scene + "</x3d>";
    X3dFile file = fixture.read(page.formatted(inside));
    fixture.assertClean();
    assertThat(file.named()).containsOnlyKeys("G");
  }

  @Test
  void problemsHaveTheirPlacesInThePage() {
    fixture.read(
        "<!DOCTYPE html>\n<html><body>\n<x3d><scene>\n  <shape><box size='1 a 2'></box></shape>\n"
            + "</scene></x3d></body></html>");
    assertThat(fixture.problems.list())
        .extracting(Problem::toString)
        .singleElement()
        .satisfies(told -> assertThat(told).startsWith("test.x3d:4:23: "));
  }

  @Test
  void aPageWithoutASceneIsTold() {
    fixture.read("<html><body>404</body></html>");
    fixture.assertOnly(
        "test.x3d:1:1: this is an HTML page without an x3d element, so it holds no scene; nothing"
            + " can be shown");
  }

  @Test
  void theFirstOfSeveralScenesIsReadAndTheOthersAreTold() {
    X3dFile file =
        fixture.read(
            "<html>\n<x3d><scene><group DEF='A'></group></scene></x3d>\n"
                + "<x3d><scene><group DEF='B'></group></scene></x3d>\n<x3d></x3d></html>");
    fixture.assertOnly(
        "test.x3d:3:1: the page has more than one x3d element; the first is read, this one and any"
            + " further ones are left out");
    assertThat(file.named()).containsOnlyKeys("A");
  }

  @Test
  void anEndTagEndsWhatIsOpenWithin() {
    X3dFile file =
        fixture.read(
            "<html><x3d><scene><group><shape></group></switch><group DEF='B'></group></scene>");
    assertThat(file.nodes()).hasSize(2);
    fixture.assertOnly(
        "test.x3d:1:81: the page ends within the x3d element; the part before it is kept");
  }

  @Test
  void aScriptKeepsItsText() {
    XmlDocument page =
        document(
            "<html><x3d><scene><script DEF='S'>\n<![CDATA[if (1 < 2) go();]]>\n</script></scene></x3d>");
    assertThat(page.elements().get(2).name()).isEqualTo("Script");
    assertThat(page.elements().get(2).text().strip()).isEqualTo("if (1 < 2) go();");
  }

  @Test
  void aPageIsConverted() {
    ProblemCollector problems = new ProblemCollector();
    for (SceneFormat format : SceneFormat.values()) {
      X3dFile again = fixture.read(format.text(document(PAGE), NodeCatalogue.load(), problems));
      fixture.assertClean();
      assertThat(again.named()).containsOnlyKeys("Box");
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void depthAttributesAndElementsAreLimited() {
    fixture.read("<html><x3d><scene>" + "<group>".repeat(100_000));
    assertLimit("nested more than 100 deep");
    fixture.read("<html><x3d><scene>" + "<group/>".repeat(100_000));
    assertLimit("more than 10000 elements");
    StringBuilder flood = new StringBuilder("<html><x3d><scene><group ");
    for (int i = 0; i < 100_000; i++) {
      flood.append('a').append(i).append(' ');
    }
    fixture.read(flood + "></group></scene></x3d>");
    assertLimit("more than 1000 attributes");
  }

  private void assertLimit(String words) {
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains(words));
  }

  @Test
  void aPageCutAtAnyByteOrChangedIsReadAsFarAsItGoes() {
    byte[] good = PAGE.getBytes(StandardCharsets.UTF_8);
    for (int length = 16; length < good.length; length += 7) {
      fixture.read(Arrays.copyOf(good, length));
      assertThat(fixture.problems.any()).isEqualTo(length < PAGE.indexOf("</X3D>") + 6);
    }
    Random random = new Random(3);
    for (int round = 0; round < 500; round++) {
      byte[] bytes = good.clone();
      for (int i = random.nextInt(5); i >= 0; i--) {
        bytes[16 + random.nextInt(bytes.length - 16)] =
            (byte) "<>/='\"&;!-[] x\n".charAt(random.nextInt(15));
      }
      fixture.read(bytes);
    }
  }
}
