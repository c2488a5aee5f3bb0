package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidDocumentException;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.grouping.Switch;

/** Scenes read from texts, streams, addresses and documents. */
class SceneFactoryReadTest {
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

  private List<Integer> events() {
    List<Integer> ids = new ArrayList<>();
    browser.addBrowserListener(event -> ids.add(event.getID()));
    return ids;
  }

  private static InputStream stream(String text) {
    return new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void aSceneOfTextIsReadButNotShownYet() {
    List<Integer> events = events();
    X3DScene scene = browser.createX3DFromString(GOOD);
    assertThat(scene.getNamedNodes()).containsExactly("S");
    assertThat(scene.getWorldURL()).isEmpty();
    assertThat(sai.scene().getRootNodes()).isEmpty();
    assertThat(events).isEmpty();
    browser.replaceWorld(scene);
    assertThat(events).containsExactly(BrowserEvent.INITIALIZED);
    assertThat(browser.getExecutionContext()).isSameAs(scene);
  }

  @Test
  void badTextIsRefusedAndGoodTextIsNotAfterIt() {
    for (String bad :
        List.of("", "#Inventor V2.1 ascii", "no X3D", "<html/>", "<X3D><Scene><Box")) {
      assertThatThrownBy(() -> browser.createX3DFromString(bad))
          .as(bad)
          .isInstanceOf(InvalidX3DException.class)
          .hasMessageContaining("holds no scene that can be read");
    }
    assertThat(sai.problems.any()).isTrue();
    assertThat(browser.createX3DFromString(SaiFixture.file("")).getRootNodes()).isEmpty();
    assertThat(browser.createX3DFromString(GOOD).getRootNodes()).hasSize(1);
    String classic = "#X3D V3.3 utf8\nPROFILE Full\nGroup {}\n";
    assertThat(browser.createX3DFromString(classic).getRootNodes()).hasSize(1);
  }

  @Test
  void aSceneWithProblemsKeepsWhatCanBeRead() {
    X3DScene scene = browser.createX3DFromString(SaiFixture.file("<Group/><Nothing/>"));
    assertThat(scene.getRootNodes()).hasSize(1);
    assertThat(sai.complaints()).anyMatch(message -> message.contains("Nothing"));
  }

  @Test
  void aStreamIsReadWithAddressesRelativeToItsOwn() throws IOException {
    write("inner.x3d", SaiFixture.file("<Group/>"));
    String text = SaiFixture.file("<Inline url='\"inner.x3d\"'/>");
    for (String base : List.of(dir.toString(), dir.resolve("outer.x3d").toUri().toString())) {
      X3DScene scene = browser.createX3DFromStream(base, stream(text));
      assertThat(scene.getWorldURL()).isEqualTo(base);
    }
    assertThat(sai.problems.any()).isFalse();
    assertThatThrownBy(() -> browser.createX3DFromStream("", stream("")))
        .isInstanceOf(InvalidX3DException.class);
    IOException broken = new IOException("broken");
    InputStream failing =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw broken;
          }
        };
    assertThatThrownBy(() -> browser.createX3DFromStream("", failing)).isSameAs(broken);
  }

  @Test
  void theFirstAddressThatCanBeReadCounts() throws IOException {
    Path file = write("scene.x3d", GOOD);
    for (String url : List.of(file.toString(), file.toUri().toString())) {
      X3DScene scene =
          browser.createX3DFromURL(new String[] {dir.resolve("no.x3d").toString(), url});
      assertThat(scene.getNamedNodes()).containsExactly("S");
      assertThat(scene.getWorldURL()).isEqualTo(file.toUri().toString());
    }
  }

  @Test
  void dataInTheAddressIsReadAndTheNetworkOnlyIfAllowed() throws IOException {
    X3DScene scene =
        browser.createX3DFromURL(
            new String[] {
              "data:model/x3d+xml;base64,"
                  + Base64.getEncoder().encodeToString(GOOD.getBytes(StandardCharsets.UTF_8))
            });
    assertThat(scene.getNamedNodes()).containsExactly("S");
    assertThatThrownBy(
            () -> browser.createX3DFromURL(new String[] {"https://example.org/scene.x3d"}))
        .isInstanceOf(InvalidURLException.class)
        .hasMessage(
            "url 'https://example.org/scene.x3d' is on the network; --allow-net example.org would"
                + " allow it");
    browser.createX3DFromStream(
        "https://example.org/scene.x3d", stream(SaiFixture.file("<Inline url='\"room.x3d\"'/>")));
    assertThat(sai.complaints())
        .containsExactly(
            "Inline url 'room.x3d' is on the network; --allow-net example.org would allow it; the"
                + " Inline is left out");
  }

  @Test
  void addressesThatCannotBeReadAreRefusedInOneSentence() throws IOException {
    String[][] bad = {
      {}, {dir.resolve("no.x3d").toString()}, {"https://example.org/scene.x3d"}, {"file:no uri"},
    };
    for (String[] urls : bad) {
      assertThatThrownBy(() -> browser.createX3DFromURL(urls))
          .isInstanceOf(InvalidURLException.class);
    }
    String empty = write("empty.x3d", "").toString();
    assertThatThrownBy(() -> browser.createX3DFromURL(new String[] {empty}))
        .isInstanceOf(InvalidX3DException.class);
  }

  @Test
  void loadingAnAddressShowsItsScene() throws IOException {
    List<Integer> events = events();
    browser.loadURL(new String[] {write("scene.x3d", GOOD).toString()}, Map.of());
    assertThat(sai.node("S", Switch.class).getWhichChoice()).isEqualTo(2);
    assertThat(events).containsExactly(BrowserEvent.INITIALIZED);
  }

  @Test
  void loadingThatFailsIsTold() throws IOException {
    List<Integer> events = events();
    String[] missing = {dir.resolve("no.x3d").toString()};
    assertThatThrownBy(() -> browser.loadURL(missing, null))
        .isInstanceOf(InvalidURLException.class);
    String[] bad = {write("bad.x3d", "nothing").toString()};
    assertThatThrownBy(() -> browser.loadURL(bad, null)).isInstanceOf(InvalidX3DException.class);
    assertThat(events).containsExactly(BrowserEvent.URL_ERROR, BrowserEvent.URL_ERROR);
  }

  @Test
  void documentsAreImported() throws Exception {
    Document document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(stream(GOOD));
    assertThat(browser.importDocument(document).getNamedNodes()).containsExactly("S");
    assertThat(browser.importDocument(document.getDocumentElement()).getNamedNodes()).hasSize(1);
    Document other = DocumentBuilderFactory.newInstance().newDocumentBuilder().newDocument();
    other.appendChild(other.createElement("html"));
    assertThatThrownBy(() -> browser.importDocument(other))
        .isInstanceOf(InvalidDocumentException.class);
    assertThatThrownBy(() -> browser.importDocument(null))
        .isInstanceOf(InvalidDocumentException.class);
  }
}
