package org.selectiverenderer.authoring;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.Gzip;

class LosslessEditingTest {
  private static final String SCENE =
      "<X3D version='4.0'><Scene><Switch DEF='A'><Shape/></Switch></Scene></X3D>";

  static Stream<Path> scenesOfTheRepository() throws IOException {
    try (Stream<Path> scenes = Files.walk(Path.of("scenes"));
        Stream<Path> objects = Files.walk(Path.of("inlineNodes"))) {
      return Stream.concat(scenes, objects)
          .filter(file -> file.toString().endsWith(".x3d"))
          .toList()
          .stream();
    }
  }

  @ParameterizedTest
  @MethodSource("scenesOfTheRepository")
  void anUnchangedSceneGivesItsBytesBack(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    SceneDocument document = SceneDocument.of(file.toString(), bytes);
    assertThat(document.fault()).isEmpty();
    assertThat(document.locked()).isEmpty();
    assertThat(document.snapshot().bytes()).isEqualTo(bytes);
  }

  /** Files as odd as they come, by what is odd about them. */
  static Map<String, byte[]> oddFiles() {
    Map<String, byte[]> files = new TreeMap<>();
    files.put("no end of line", utf8(SCENE));
    files.put("byte order mark", utf8("\ufeff<?xml version='1.0'?>\n" + SCENE + "\n"));
    files.put("CR LF", utf8("<?xml version=\"1.0\"?>\r\n" + SCENE.replace(">", ">\r\n")));
    files.put("CR", utf8(SCENE.replace(">", ">\r")));
    files.put("mixed ends of lines", utf8("\r\n\n\r" + SCENE + "\n\r\n\r\r"));
    files.put("UTF-16 LE", mark(0xff, 0xfe, SCENE.getBytes(StandardCharsets.UTF_16LE)));
    files.put("UTF-16 BE", mark(0xfe, 0xff, SCENE.getBytes(StandardCharsets.UTF_16BE)));
    files.put("UTF-16 without mark", SCENE.getBytes(StandardCharsets.UTF_16LE));
    files.put("Latin 1", declared("ISO-8859-1", "caf\u00e9"));
    files.put("Greek", declared("ISO-8859-7", "\u03c0\u03bb\u03ac\u03c4\u03b7"));
    files.put("Shift_JIS", declared("Shift_JIS", "\u6905\u5b50"));
    files.put(
        "beyond the basic plane",
        utf8(SCENE.replace("Shape", "A\ud83d\ude00B").replace("'A'", "'\ud83d\ude00'")));
    files.put(
        "DOCTYPE with entities",
        utf8("<!DOCTYPE X3D [<!ENTITY a \"b\"> <!-- > -->]>" + SCENE.replace("<Shape/>", "&a;")));
    files.put(
        "quotes",
        utf8("<X3D  a = \"'\"   b='\"'\n\tc='&quot;&#65;&amp;>'><Scene ></Scene\n></X3D >"));
    files.put(
        "CDATA", utf8("<X3D><Scene><Script><![CDATA[<a>]] > ]]></Script></Scene></X3D><!-- -->"));
    files.put("processing instruction", utf8("<?a <b> ?><X3D><?c?><Scene/></X3D>"));
    files.put("prefixes", utf8("<x:X3D xmlns:x='u'><x:Scene y='1'/></x:X3D>"));
    files.put("gzip", Gzip.packed(utf8(SCENE)));
    files.put("gzip of another program", other(Gzip.packed(utf8(SCENE))));
    files.put("bytes of no encoding", new byte[] {'<', 'X', '>', (byte) 0xff, '<', '/', 'X', '>'});
    files.put("odd UTF-16", mark(0xff, 0xfe, new byte[] {'<', 0, 'X'}));
    files.put("unknown encoding", utf8("<?xml version='1.0' encoding='klingon'?>" + SCENE));
    files.put("a lone surrogate", mark(0xff, 0xfe, new byte[] {'<', 0, 0, (byte) 0xd8, '>', 0}));
    files.put("cut off", utf8(SCENE.substring(0, 40)));
    files.put("crossed tags", utf8("<X3D><Scene><a></b></Scene></X3D>"));
    files.put("VRML", utf8("#VRML V2.0 utf8\nShape {}\n"));
    files.put("nothing", new byte[0]);
    files.put("zeros", new byte[100]);
    return files;
  }

  @ParameterizedTest
  @MethodSource("oddNames")
  void anOddFileGivesItsBytesBack(String name) throws IOException {
    byte[] bytes = oddFiles().get(name);
    SceneDocument document = SceneDocument.of(name, bytes);
    assertThat(document.snapshot().bytes()).isEqualTo(bytes);
    assertThat(document.tree().isPresent()).isNotEqualTo(document.fault().isPresent());
  }

  @ParameterizedTest
  @MethodSource("oddNames")
  void anOddFileGivesItsBytesBackAfterAnEditAndItsUndoing(String name) throws IOException {
    byte[] bytes = oddFiles().get(name);
    SceneDocument document = SceneDocument.of(name, bytes);
    if (document.locked().isPresent()) {
      return; // told by the next test
    }
    document.type(0, 0, "<!-- \u00e9 -->");
    assertThat(document.snapshot().bytes()).isNotEqualTo(bytes);
    document.history().undo();
    assertThat(document.snapshot().bytes()).isEqualTo(bytes);
  }

  static List<String> oddNames() {
    return List.copyOf(oddFiles().keySet());
  }

  @Test
  void onlyWhatCannotBeWrittenAgainIsLocked() throws IOException {
    List<String> locked =
        oddFiles().entrySet().stream()
            .filter(file -> open(file.getKey(), file.getValue()).locked().isPresent())
            .map(Map.Entry::getKey)
            .toList();
    assertThat(locked)
        .containsExactly(
            "a lone surrogate", "bytes of no encoding", "odd UTF-16", "unknown encoding");
  }

  private static SceneDocument open(String name, byte[] bytes) {
    try {
      return SceneDocument.of(name, bytes);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aCharacterThatTheEncodingLacksBecomesAReference() throws IOException {
    SceneDocument document = SceneDocument.of("a.x3d", declared("ISO-8859-1", "caf\u00e9"));
    int at = document.text().toString().indexOf("caf");
    document.type(at, at, "\u03b1");
    assertThat(new String(document.snapshot().bytes(), StandardCharsets.ISO_8859_1))
        .contains("&#945;caf\u00e9");
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] declared(String encoding, String word) {
    String head = "<?xml version='1.0' encoding='" + encoding + "'?>\n";
    return (head + SCENE.replace("'A'", "'" + word + "'")).getBytes(Charset.forName(encoding));
  }

  private static byte[] mark(int first, int second, byte[] text) {
    byte[] bytes = new byte[text.length + 2];
    bytes[0] = (byte) first;
    bytes[1] = (byte) second;
    System.arraycopy(text, 0, bytes, 2, text.length);
    return bytes;
  }

  /** With a time and a system in its head, as gzip writes it. */
  private static byte[] other(byte[] packed) {
    packed[4] = 77;
    packed[9] = 3;
    return packed;
  }

  @Test
  void aTextThatIsNotWellFormedIsSoWhereTheReaderSays() throws IOException {
    byte[] bytes = "<X3D>\n <Scene></X3D>".getBytes(StandardCharsets.UTF_8);
    ProblemCollector problems = new ProblemCollector();
    new X3dReader(NodeCatalogue.load()).read("s.x3d", bytes, problems);

    SourceLocation place = SceneDocument.of("s.x3d", bytes).fault().orElseThrow().location();

    assertThat(place).isEqualTo(problems.list().get(0).location());
    assertThat(place).isEqualTo(new SourceLocation("s.x3d", 2, 9));
  }

  @Test
  void anElementOfAnotherLanguageKeepsItsPrefix() throws IOException {
    String text = "<X3D><ds:Switch xmlns:ds='urn:x' DEF='A'/><Switch DEF='B'/></X3D>";
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);

    assertThat(SceneDocument.of("s.x3d", bytes).tree().orElseThrow().switches()).hasSize(1);
  }
}
